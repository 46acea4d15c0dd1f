// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace sphinx {

/// Allocator of cache-line aligned memory that leaves plain numbers uninitialised on resize,
/// so that a large buffer is touched first by the loop that fills it.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};

    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}

    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
    template <class U>
    void construct(U* p) {
        ::new (static_cast<void*>(p)) U;
    }
    template <class U, class... Args>
    void construct(U* p, Args&&... args) {
        ::new (static_cast<void*>(p)) U(static_cast<Args&&>(args)...);
    }
    bool operator==(const AlignedAllocator&) const { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// Makes it n long, of which nothing is kept. Room is asked for once, with a little to spare: a
/// vector that grows by itself takes twice as much, and leaves holes in memory.
template <class T>
void makeRoom(AlignedVector<T>& vector, std::size_t n) {
    if (vector.capacity() < n) {
        vector = {};
        vector.reserve(n + n / 16);
    }
    vector.resize(n);
}

}  // namespace sphinx
