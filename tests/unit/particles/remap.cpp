// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/remap.h"
#include "particles/side_array.h"

#include "../memory_archive.h"

#include <catch2/catch.hpp>

#include <optional>

using namespace sphinx;
using namespace sphinx::particles;

namespace {

constexpr Index none = Remap::none;

/// What was told last.
struct Told {
    std::vector<Index> from, to;
    std::size_t carried = 0;
    int times = 0;

    void operator()(const Remap& remap) {
        ++times;
        carried = remap.carried();
        from.clear();
        to.clear();
        for (std::size_t k = 0; k < remap.after(); ++k) from.push_back(remap.from(k));
        for (std::size_t i = 0; i < remap.before(); ++i) to.push_back(remap.to(i));
    }
};

using Places = std::vector<Index>;

}  // namespace

TEST_CASE("a listener is told where the particles went") {
    ParticleSet<2> particles;
    particles.append(4);
    Told told;
    const RemapSubscription subscription(particles.remaps(), std::ref(told));

    SECTION("some came") {
        particles.append(2);
        CHECK(told.from == Places{0, 1, 2, 3, none, none});
        CHECK(told.to == Places{0, 1, 2, 3});
        CHECK(told.carried == 4);
    }
    SECTION("some went") {
        particles.remove({1, 2});
        CHECK(told.from == Places{0, 3});
        CHECK(told.to == Places{0, none, none, 1});
        CHECK(told.carried == 2);
    }
    SECTION("all went") {
        particles.remove({0, 1, 2, 3});
        CHECK(told.from.empty());
        CHECK(told.to == Places{none, none, none, none});
    }
    SECTION("they changed places") {
        particles.permute({2, 0, 3, 1});
        CHECK(told.from == Places{2, 0, 3, 1});
        CHECK(told.to == Places{1, 3, 0, 2});
    }
    SECTION("all are others") {
        particles.restore(2, 9);
        CHECK(told.from == Places{none, none});
        CHECK(told.to == Places{none, none, none, none});
    }
    CHECK(told.times == 1);
}

TEST_CASE("a listener hears nothing before and after its life, nor of nothing") {
    ParticleSet<3> particles;
    particles.append(2);
    Told first, second;
    std::optional<RemapSubscription> short_lived(std::in_place, particles.remaps(),
                                                 std::ref(first));
    const RemapSubscription lasting(particles.remaps(), std::ref(second));
    particles.append(1);
    short_lived.reset();
    particles.append(1);
    particles.remove({});
    CHECK(first.times == 1);
    CHECK(second.times == 2);
}

TEST_CASE("when a listener is told, the particles are where they belong") {
    ParticleSet<2> particles;
    auto& start = particles.vector(fields::initial_position);
    const auto give = [&](std::size_t first) { particles.position()[first].setConstant(5); };
    bool right = false;
    const RemapSubscription subscription(particles.remaps(), [&](const Remap& remap) {
        right = start[remap.carried()] == Vec<2>::Constant(5) && particles.size() == remap.after();
    });
    particles.append(1, give);
    CHECK(right);
}

TEST_CASE("a side array follows its particles") {
    ParticleSet<2> particles;
    particles.append(3);
    // Of each particle ten times its id; a new one is marked.
    SideArray<double> values(particles,
                             [](std::size_t i) { return 1000 + static_cast<double>(i); });
    CHECK(values.size() == 3);
    CHECK(values[2] == 1002);
    const auto fill = [&] {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = 10 * static_cast<double>(particles.id()[i]);
    };
    const auto now = [&] {
        return std::vector<double>(values.data(), values.data() + values.size());
    };
    fill();
    particles.permute({2, 0, 1});
    CHECK(now() == std::vector<double>{20, 0, 10});
    particles.append(2);
    CHECK(now() == std::vector<double>{20, 0, 10, 1003, 1004});
    fill();
    particles.remove({1, 3});
    CHECK(now() == std::vector<double>{20, 10, 40});
    particles.restore(2, 6);
    CHECK(now() == std::vector<double>{1000, 1001});
}

TEST_CASE("a side array goes into a restart by particle, wherever they stand") {
    ParticleSet<2> particles;
    particles.append(4);
    const auto byId = [&](std::size_t i) -> Vec<2> {
        return Vec<2>(static_cast<double>(particles.id()[i]), 0.5);
    };
    SideArray<Vec<2>> values(particles, byId);
    particles.permute({2, 0, 3, 1});
    test::MemoryArchive archive;
    values.transfer(archive, "values");

    // A resumed run begins in the order of ids.
    ParticleSet<2> resumed;
    resumed.append(4);
    SideArray<Vec<2>> back(resumed, [](std::size_t) -> Vec<2> { return Vec<2>::Zero(); });
    archive.is_loading = true;
    back.transfer(archive, "values");
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(back[i] == Vec<2>(static_cast<double>(resumed.id()[i]), 0.5));

    resumed.append(1);
    CHECK_THROWS_WITH(back.transfer(archive, "values"),
                      "the restart has another number of values for values");
}
