// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/id_order.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace sphinx;
using namespace sphinx::particles;

namespace {

/// Values of the x coordinate in the order of a file.
std::vector<double> inFile(ParticleSet<2>& particles) {
    AlignedVector<char> buffer;
    const IdOrder order(particles);
    const std::string_view bytes = order.bytes(particles.position(), buffer);
    REQUIRE(bytes.size() == sizeof(Vec<2>) * order.size());
    std::vector<double> values(order.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        std::memcpy(&values[k], bytes.data() + sizeof(Vec<2>) * k, sizeof(double));
    return values;
}

}  // namespace

TEST_CASE("files have particles by their ids, wherever they stand in memory") {
    ParticleSet<2> particles;
    particles.append(5);
    for (std::size_t i = 0; i < 5; ++i) particles.position()[i] << 10.0 * static_cast<double>(i), 0;
    particles.remove({1});
    CHECK(inFile(particles) == std::vector<double>{0, 20, 30, 40});
    particles.permute({3, 0, 2, 1});
    CHECK(inFile(particles) == std::vector<double>{0, 20, 30, 40});
    const IdOrder order(particles);
    CHECK(order[0] == 1);
    CHECK(order[3] == 0);
    particles.remove({0, 1, 2, 3});
    CHECK(inFile(particles).empty());
}

TEST_CASE("what stands by ids already is not copied") {
    ParticleSet<2> particles;
    particles.append(3);
    AlignedVector<char> buffer;
    const IdOrder order(particles);
    CHECK(static_cast<const void*>(order.bytes(particles.position(), buffer).data()) ==
          particles.position().data());
    CHECK(buffer.empty());
}
