/* SPDX-FileCopyrightText: 2026 The sphinx developers
 * SPDX-License-Identifier: Apache-2.0
 *
 * Preloaded into a process: kills it like `kill -9` right before its N-th call that changes a file
 * (DIE_AT_CALL=N), or sends it the signal DIE_BY instead. With CALLS_COUNTED=FILE the number of such calls is written to FILE at the end.
 * Of a fatal write with an odd N half of the bytes still reach the file, as in a real kill within a
 * long write; with an even N nothing does.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;
static long fatal_call;
static int fatal_signal;

__attribute__((constructor)) static void begin(void) {
    const char* text = getenv("DIE_AT_CALL");
    const char* by = getenv("DIE_BY");
    fatal_call = text ? atol(text) : 0;
    fatal_signal = by ? atoi(by) : SIGKILL;
    /* What a sanitizer did before is not the program's. */
    atomic_store(&calls, 0);
}

__attribute__((destructor)) static void end(void) {
    const char* path = getenv("CALLS_COUNTED");
    FILE* file = path ? fopen(path, "w") : NULL;
    if (!file) return;
    fprintf(file, "%ld\n", atomic_load(&calls));
    fclose(file);
}

static int is_fatal(void) { return atomic_fetch_add(&calls, 1) + 1 == fatal_call; }

static size_t half(size_t size) { return fatal_call % 2 ? size / 2 : 0; }

static void die(void) { kill(getpid(), fatal_signal); }

/* Who survives the signal writes everything itself. */
static int leaves_half(void) { return fatal_signal == SIGKILL; }

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int descriptor, const void* bytes, size_t size) {
    /* What is said on the terminal is no file. */
    if (descriptor > 2 && is_fatal()) {
        if (leaves_half()) NEXT(write)(descriptor, bytes, half(size));
        die();
    }
    return NEXT(write)(descriptor, bytes, size);
}

ssize_t writev(int descriptor, const struct iovec* parts, int count) {
    if (descriptor > 2 && is_fatal()) die();
    return NEXT(writev)(descriptor, parts, count);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset) {
    if (is_fatal()) {
        if (leaves_half()) NEXT(pwrite)(descriptor, bytes, half(size), offset);
        die();
    }
    return NEXT(pwrite)(descriptor, bytes, size, offset);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t offset) {
    if (is_fatal()) {
        if (leaves_half()) NEXT(pwrite64)(descriptor, bytes, half(size), offset);
        die();
    }
    return NEXT(pwrite64)(descriptor, bytes, size, offset);
}

int fsync(int descriptor) {
    if (is_fatal()) die();
    return NEXT(fsync)(descriptor);
}

int ftruncate(int descriptor, off_t size) {
    if (is_fatal()) die();
    return NEXT(ftruncate)(descriptor, size);
}

int ftruncate64(int descriptor, off64_t size) {
    if (is_fatal()) die();
    return NEXT(ftruncate64)(descriptor, size);
}

int rename(const char* from, const char* to) {
    if (is_fatal()) die();
    return NEXT(rename)(from, to);
}

int unlink(const char* path) {
    if (is_fatal()) die();
    return NEXT(unlink)(path);
}

int unlinkat(int folder, const char* path, int flags) {
    if (is_fatal()) die();
    return NEXT(unlinkat)(folder, path, flags);
}

int mkdir(const char* path, mode_t mode) {
    if (is_fatal()) die();
    return NEXT(mkdir)(path, mode);
}
