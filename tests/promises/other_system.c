/* SPDX-FileCopyrightText: 2026 The sphinx developers
 * SPDX-License-Identifier: Apache-2.0
 *
 * Preloaded into a process, which then finds itself on another system:
 * - GROUPS_IN=FOLDER: files of /proc/self/cgroup and /sys/fs/cgroup are those below FOLDER.
 * - LIBRARIES_IN=FILE: every function is found in that library.
 * - FLOCK_FAILS=ERRNO: no file can be locked, for this reason.
 * - MEMORY_ENDS_AT=N: there is no memory for the N-th allocation of a kilobyte or more, and after
 * that no more for any than is freed. With ALLOCATIONS_COUNTED=FILE their number is written to FILE
 * at the end. Not with a sanitizer, whose allocations are its own.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static const char* place_of(const char* path, char* other) {
    const char* folder = getenv("GROUPS_IN");
    if (!folder || (strcmp(path, "/proc/self/cgroup") && strncmp(path, "/sys/fs/cgroup/", 15)))
        return path;
    snprintf(other, PATH_MAX, "%s%s", folder, path);
    return other;
}

FILE* fopen(const char* path, const char* mode) {
    char other[PATH_MAX];
    return NEXT(fopen)(place_of(path, other), mode);
}

FILE* fopen64(const char* path, const char* mode) {
    char other[PATH_MAX];
    return NEXT(fopen64)(place_of(path, other), mode);
}

int dladdr(const void* address, Dl_info* info) {
    const char* file = getenv("LIBRARIES_IN");
    const int found = NEXT(dladdr)(address, info);
    if (file) info->dli_fname = file;
    return found;
}

int flock(int descriptor, int operation) {
    const char* reason = getenv("FLOCK_FAILS");
    if (!reason) return NEXT(flock)(descriptor, operation);
    errno = atoi(reason);
    return -1;
}

#ifndef SANITIZED

enum { counted_size = 1024 };
/* Allocations so far; the first that fails; bytes that were freed after that one. */
static atomic_long allocations;
static atomic_long first_failure = LONG_MAX;
static atomic_long freed;

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

__attribute__((constructor)) static void begin(void) {
    const char* text = getenv("MEMORY_ENDS_AT");
    atomic_store(&allocations, 0);
    if (text) atomic_store(&first_failure, atol(text));
}

__attribute__((destructor)) static void end(void) {
    const char* path = getenv("ALLOCATIONS_COUNTED");
    const long counted = atomic_load(&allocations);
    atomic_store(&first_failure, LONG_MAX);
    FILE* file = path ? fopen(path, "w") : NULL;
    if (!file) return;
    fprintf(file, "%ld\n", counted);
    fclose(file);
}

static int has_ended(void) { return atomic_load(&allocations) >= atomic_load(&first_failure); }

/* For so many bytes more. */
static int has_room(size_t size) {
    if (!has_ended()) {
        if (size < counted_size || atomic_fetch_add(&allocations, 1) + 1 < first_failure) return 1;
    } else {
        long left = atomic_load(&freed);
        while (size <= (size_t)left)
            if (atomic_compare_exchange_weak(&freed, &left, left - (long)size)) return 1;
    }
    errno = ENOMEM;
    return 0;
}

void free(void* place) {
    if (place && has_ended()) atomic_fetch_add(&freed, (long)malloc_usable_size(place));
    __libc_free(place);
}

void* malloc(size_t size) { return has_room(size) ? __libc_malloc(size) : NULL; }

void* calloc(size_t count, size_t size) {
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes)) bytes = PTRDIFF_MAX;
    return has_room(bytes) ? __libc_calloc(count, size) : NULL;
}

void* realloc(void* old, size_t size) {
    const size_t before = old ? malloc_usable_size(old) : 0;
    return has_room(size > before ? size - before : 0) ? __libc_realloc(old, size) : NULL;
}

void* aligned_alloc(size_t alignment, size_t size) {
    return has_room(size) ? __libc_memalign(alignment, size) : NULL;
}

void* memalign(size_t alignment, size_t size) { return aligned_alloc(alignment, size); }

int posix_memalign(void** place, size_t alignment, size_t size) {
    void* found = aligned_alloc(alignment, size);
    if (!found) return ENOMEM;
    *place = found;
    return 0;
}

#endif
