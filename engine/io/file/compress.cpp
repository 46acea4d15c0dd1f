// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/compress.h"

#include "core/errors.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace sphinx::io {
namespace {

constexpr std::size_t piece_size = 32768;

Bytef* bytePointer(const char* p) {
    return reinterpret_cast<Bytef*>(const_cast<char*>(p));  // zlib's input pointer is not const
}

/// Bits per byte that a code of the byte frequencies needs at least.
double entropy(std::string_view piece) {
    // Four tables, so that equal neighbors do not wait for each other's increment.
    std::array<std::array<std::uint32_t, 256>, 4> counts{};
    std::size_t k = 0;
    for (const char c : piece) ++counts[k++ & 3][static_cast<unsigned char>(c)];
    double sum = 0;
    for (std::size_t value = 0; value < 256; ++value) {
        const double n = counts[0][value] + counts[1][value] + counts[2][value] + counts[3][value];
        if (n > 0) sum += n * std::log2(n);
    }
    const double size = static_cast<double>(piece.size());
    return std::log2(size) - sum / size;
}

/// How to deflate a piece. Measured on positions and velocities of particles: above 7.2 bits a byte
/// (64-bit numbers without pattern) nothing saves a tenth; between 5 and 7.2 (the same with zeros
/// in between, 32-bit numbers) runs alone save almost as much as a search for repetitions and take
/// half of the time; below (ids, lattices, constants) the search pays.
struct Method {
    int level = 1;
    int strategy = Z_DEFAULT_STRATEGY;
    bool operator==(const Method&) const = default;
};

Method methodFor(std::string_view piece) {
    const double bits = entropy(piece);
    if (bits > 7.2) return {0, Z_DEFAULT_STRATEGY};
    if (bits > 5) return {1, Z_RLE};
    return {};
}

class Deflater {
 public:
    explicit Deflater(std::size_t size) {
        if (deflateInit(&stream_, 1) != Z_OK) throw std::bad_alloc();
        // Room for the worst case, and for the block ends that a change of level adds.
        out_.resize(deflateBound(&stream_, size) + 64 + 16 * (size / piece_size + 1));
        stream_.next_out = bytePointer(out_.data());
    }
    ~Deflater() { deflateEnd(&stream_); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void add(std::string_view piece, Method method) {
        stream_.avail_out = room();
        if (method != method_) {
            deflateParams(&stream_, method.level, method.strategy);
            method_ = method;
        }
        stream_.next_in = bytePointer(piece.data());
        stream_.avail_in = static_cast<uInt>(piece.size());
        run(Z_NO_FLUSH);
    }
    std::string finish() {
        run(Z_FINISH);
        out_.resize(static_cast<std::size_t>(stream_.next_out - bytePointer(out_.data())));
        return std::move(out_);
    }

 private:
    uInt room() const {
        const auto used = static_cast<std::size_t>(stream_.next_out - bytePointer(out_.data()));
        return static_cast<uInt>(
            std::min<std::size_t>(out_.size() - used, std::numeric_limits<uInt>::max()));
    }
    void run(int flush) {
        for (;;) {
            stream_.avail_out = room();
            const int result = deflate(&stream_, flush);
            if (flush == Z_FINISH ? result == Z_STREAM_END : stream_.avail_in == 0) return;
            if (room() < 64) {
                const auto used =
                    static_cast<std::size_t>(stream_.next_out - bytePointer(out_.data()));
                out_.resize(2 * out_.size());
                stream_.next_out = bytePointer(out_.data()) + used;
            }
        }
    }

    z_stream stream_{};
    std::string out_;
    Method method_;
};

}  // namespace

std::string compress(std::string_view bytes) {
    Deflater deflater(bytes.size());
    while (!bytes.empty()) {
        const std::string_view piece = bytes.substr(0, piece_size);
        deflater.add(piece, methodFor(piece));
        bytes.remove_prefix(piece.size());
    }
    return deflater.finish();
}

bool decompress(std::string_view stream, char* to, std::size_t size) {
    constexpr std::size_t limit = std::numeric_limits<uInt>::max();
    if (stream.size() > limit || size > limit) return false;
    // zlib takes an output of no bytes for one of any size, so it gets one byte more to fill.
    char spare = 0;
    uLongf written = size > 0 ? size : 1;
    uLong consumed = stream.size();
    return uncompress2(bytePointer(size > 0 ? to : &spare), &written, bytePointer(stream.data()),
                       &consumed) == Z_OK &&
           written == size && consumed == stream.size();
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t previous) {
    return static_cast<std::uint32_t>(crc32_z(previous, bytePointer(bytes.data()), bytes.size()));
}

std::uint64_t fingerprint(std::string_view bytes) {
    // Four independent lanes of multiply and rotate, joined at the end.
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    std::array<std::uint64_t, 4> lanes{odd, odd << 1, odd << 2, odd << 3};
    const std::size_t words = bytes.size() / 8;
    const auto mix = [](std::uint64_t lane, std::uint64_t word) {
        return std::rotl((lane ^ word) * odd, 29);
    };
    for (std::size_t w = 0; w < words; ++w) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data() + 8 * w, 8);
        lanes[w & 3] = mix(lanes[w & 3], word);
    }
    std::uint64_t result = mix(odd, bytes.size());
    for (const std::uint64_t lane : lanes) result = mix(result, lane);
    for (const char c : bytes.substr(8 * words))
        result = mix(result, static_cast<unsigned char>(c));
    return mix(result, result >> 31);
}

}  // namespace sphinx::io
