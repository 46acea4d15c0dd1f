// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/restart/restart.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "io/file/compress.h"
#include "io/frames/arrays.h"
#include "support.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cfloat>
#include <cstring>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

const std::vector<std::uint64_t> odd_bits{
    0x7ff8000000000000,  // NaN
    0xfff8000000000000,  // the NaN that the processor makes
    0x7ff0000000000001,  // signalling NaN
    0x7fffdeadbeef0001,  // NaN with a message
    0x8000000000000000,  // -0
    0x0000000000000001,  // smallest denormal
    0x000fffffffffffff,  // largest denormal
    0x7ff0000000000000,  // infinity
    0xfff0000000000000,
    0x7fefffffffffffff,  // largest number
    0x3fb999999999999a,  // 0.1
};

template <int Dim>
void setOddValues(bodies::Body<Dim>& body) {
    setValues(body, 1);
    double* numbers = body.particles.vector(fields::velocity).numbers();
    for (std::size_t k = 0; k < odd_bits.size(); ++k)
        numbers[k] = std::bit_cast<double>(odd_bits[k]);
}

std::vector<double> oddNumbers() {
    std::vector<double> numbers;
    for (const std::uint64_t bits : odd_bits) numbers.push_back(std::bit_cast<double>(bits));
    return numbers;
}

struct State {
    double number = std::bit_cast<double>(std::uint64_t{0xfff8000000000123});
    std::int64_t integer = INT64_MIN;
    std::string text = "a <b> & \"c\"\n\td\r";
    std::string binary = std::string("\0\1\xff\xc0", 4);
    double inner = -0.0;
    bool flag = true;
    std::vector<double> numbers = oddNumbers();
    std::vector<std::int64_t> integers{INT64_MIN, 0, INT64_MAX};
    std::vector<double> nothing;

    void transfer(Archive& archive) {
        CHECK(archive.has("number"));
        CHECK(archive.has("inside \"&<\""));
        CHECK(archive.has("nobody") != archive.loading());
        archive.value("number", number);
        archive.value("integer", integer);
        Section section(archive, "inside \"&<\"");
        archive.value("text", text);
        archive.value("binary", binary);
        archive.value("number", inner);
        archive.value("flag", flag);
        archive.value("numbers", numbers);
        archive.value("integers", integers);
        archive.value("nothing", nothing);
    }
};

RestartHeader makeHeader() {
    RestartHeader header;
    header.program = "1.2.3";
    header.commit = "abc";
    header.case_name = "tank";
    header.digest = "0123";
    header.case_text = "title: \"a < b\"\n# \xc3\xa9\n";
    header.instruction_set = "x86-64";
    header.build_and_machine.entries = {{"flags", "-O3 \"quoted\""}, {"threads", "2"}};
    header.time = 1.0 / 3;
    header.steps = 100;
    return header;
}

template <int Dim>
bool sameBits(bodies::Body<Dim>& a, bodies::Body<Dim>& b) {
    if (a.size() != b.size() || a.particles.nextId() != b.particles.nextId()) return false;
    for (const auto& field : a.particles.all()) {
        const particles::FieldBase* other = b.particles.find(field->info().name);
        if (fieldFingerprint(*field, particles::IdOrder(a.particles)) !=
            fieldFingerprint(*other, particles::IdOrder(b.particles)))
            return false;
    }
    return true;
}

/// A small restart of a 2D body.
struct Written {
    TemporaryFolder folder;
    Path path = folder / "tank_100.xml";
    std::unique_ptr<bodies::Body<2>> body = makeBody<2>("water", 9);
    State state;
    std::vector<std::string> names{"velocity", "pressure", "mass", "strain"};

    explicit Written(RestartEncoding encoding = RestartEncoding::zlib) {
        setOddValues(*body);
        write(encoding);
    }
    void write(RestartEncoding encoding) {
        RestartHeader header = makeHeader();
        writeRestart<2>(
            path, header, [&](Archive& a) { state.transfer(a); }, {{body.get(), names}}, encoding);
    }
    void read(bodies::Body<2>& target) {
        State loaded{0, 0, "", "", 0, false, {}, {}, {1}};
        readRestart<2>(path, [&](Archive& a) { loaded.transfer(a); }, {{&target, names}});
        CHECK(std::bit_cast<std::uint64_t>(loaded.number) ==
              std::bit_cast<std::uint64_t>(state.number));
        CHECK(loaded.integer == state.integer);
        CHECK(loaded.text == state.text);
        CHECK(loaded.binary == state.binary);
        CHECK(std::signbit(loaded.inner));
        CHECK(loaded.flag);
        REQUIRE(loaded.numbers.size() == odd_bits.size());
        CHECK(std::memcmp(loaded.numbers.data(), odd_bits.data(), 8 * odd_bits.size()) == 0);
        CHECK(loaded.integers == state.integers);
        CHECK(loaded.nothing.empty());
    }
    std::string content() const { return readFile(path, 1 << 26); }
    /// The file with other content and a checksum that fits.
    void replace(const std::string& from, const std::string& to) {
        std::string text = content();
        const std::size_t place = text.find(from);
        REQUIRE(place != text.npos);
        text.replace(place, from.size(), to);
        text.resize(text.size() - restartEnd(0).size());
        writeFileAtomically(path, text + restartEnd(checksum(text)));
    }
    std::string problem() {
        auto target = makeBody<2>("water", 0);
        try {
            readRestart<2>(path, [&](Archive& a) { State().transfer(a); }, {{target.get(), names}});
        } catch (const FileError& error) {
            const std::string text = error.what();
            CHECK(text.find('\n') == text.npos);
            CHECK(text.find(path.string()) != text.npos);
            return text;
        }
        return "";
    }
};

}  // namespace

TEST_CASE("a restart gives back every bit") {
    const auto encoding = GENERATE(RestartEncoding::zlib, RestartEncoding::text);
    Written written(encoding);
    auto target = makeBody<2>("water", 20);
    written.read(*target);
    CHECK(sameBits(*written.body, *target));
    const RestartHeader expected = makeHeader(), header = readRestartHeader(written.path);
    CHECK(header.program == expected.program);
    CHECK(header.commit == expected.commit);
    CHECK(header.case_name == expected.case_name);
    CHECK(header.digest == expected.digest);
    CHECK(header.case_text == expected.case_text);
    CHECK(header.instruction_set == expected.instruction_set);
    CHECK(header.dimension == 2);
    CHECK(header.time == expected.time);
    CHECK(header.steps == expected.steps);
    CHECK_THAT(written.content(),
               Catch::Matchers::Contains(" flags=\"-O3 &quot;quoted&quot;\" threads=\"2\" time="));
}

TEST_CASE("a restart of several pieces and bodies in 3D") {
    const auto encoding = GENERATE(RestartEncoding::zlib, RestartEncoding::text);
    setThreadCount(2);
    TemporaryFolder folder;
    auto water = makeBody<3>("water", 50000);  // strain has 450000 values: seven pieces
    auto wall = makeBody<3>("wall", 0);
    setValues(*water, 1);
    water->particles.remove({0, 7});
    const std::vector<std::string> names{"velocity", "pressure", "mass", "strain"};
    RestartHeader header = makeHeader();
    header.dimension = 3;
    writeRestart<3>(
        folder / "a.xml", header, [](Archive&) {}, {{water.get(), names}, {wall.get(), names}},
        encoding);
    auto water_read = makeBody<3>("water", 3), wall_read = makeBody<3>("wall", 5);
    readRestart<3>(folder / "a.xml", [](Archive&) {},
                   {{wall_read.get(), names}, {water_read.get(), names}});
    CHECK(sameBits(*water, *water_read));
    CHECK(wall_read->size() == 0);
    setThreadCount(1);
}

TEST_CASE("a restart does not tell where the particles stood in memory") {
    Written written;
    const std::string before = written.content();
    written.body->particles.permute({3, 0, 8, 1, 2, 7, 6, 5, 4});
    written.write(RestartEncoding::zlib);
    CHECK(written.content() == before);
    auto target = makeBody<2>("water", 0);
    written.read(*target);
    CHECK(target->particles.id()[3] == 3);
    CHECK(sameBits(*written.body, *target));
}

TEST_CASE("a restart of another format is refused in one line") {
    const Path path = Path(SPHINX_TEST_DATA) / "format_1.xml";
    CHECK_THROWS_WITH(
        readRestartHeader(path),
        "cannot read " + path.string() + ": it has format 1, and this program reads format 2");
}

TEST_CASE("a damaged restart is refused, whichever byte it is") {
    const auto encoding = GENERATE(RestartEncoding::zlib, RestartEncoding::text);
    Written written(encoding);
    const std::string good = written.content();
    std::size_t refused = 0;
    for (std::size_t k = 0; k < good.size(); ++k) {
        std::string bad = good;
        bad[k] = static_cast<char>(bad[k] ^ (1 << k % 8));
        File::create(written.path).write(bad);
        refused += written.problem().empty() ? 0 : 1;
    }
    CHECK(refused == good.size());
}

TEST_CASE("a restart cut short or grown is refused") {
    Written written;
    const std::string good = written.content();
    std::size_t refused = 0;
    for (std::size_t size = 0; size < good.size(); ++size) {
        File::create(written.path).write(good.substr(0, size));
        refused += written.problem().empty() ? 0 : 1;
    }
    CHECK(refused == good.size());
    File::create(written.path).write(good + "\n");
    CHECK(written.problem().find("cut short or damaged") != std::string::npos);
    File::create(written.path).write(good + good);
    CHECK(written.problem().find("cut short or damaged") != std::string::npos);
}

TEST_CASE("a restart with a right checksum but wrong content is refused with its reason") {
    Written written;
    const auto problem = [&](const std::string& from, const std::string& to) {
        written.write(RestartEncoding::text);
        written.replace(from, to);
        return written.problem();
    };
    const auto has = [](const std::string& part) { return Catch::Contains(part); };
    struct Change {
        std::string from, to, message;
    };
    for (const auto& [from, to, message] : std::vector<Change>{
             {"format=\"2\"", "format=\"3\"", "it has format 3"},
             {"dimension=\"2\"", "dimension=\"3\"", "dimension 3"},
             {"<state>", "<stage>", "the state is missing"},
             {"steps=\"100\"", "steps=\"-1\"", "'steps'"},
             {"body name=\"water\"", "body name=\"wine\"", "no body 'water'"},
             {"particles=\"9\"", "particles=\"4000000000\"", "fewer ids than particles"},
             {"particles=\"9\"", "particles=\"8\"", "more values than particles"},
             {"particles=\"9\"", "particles=\"99999999999\"", "'particles'"},
             {"next_id=\"9\"", "next_id=\"8\"", "an id is out of range"},
             {"crc32=\"33ff69c2\">0 1", "crc32=\"12c117c3\">1 0", "the ids do not ascend"},
             {"crc32=\"33ff69c2\">0 1", "crc32=\"bcca4457\">0 0", "the ids do not ascend"},
             {"name=\"pressure\"", "name=\"presure\"", "without field 'pressure'"},
             {"name=\"id\"", "name=\"ids\"", "the ids must come first"},
             {"components=\"2\"", "components=\"3\"", "number of components"},
             {"values=\"9\"", "values=\"9000000\"", "'values'"},
             {"values=\"9\"", "values=\"7\"", "damaged"},
             {"0.5 0.5", "0.5 0.6", "damaged"},
             {"0.5 0.5", "0.5 &lt;", "damaged"},
             {"0.5 0.5", "0.5 &bad;", "unknown entity"},
             {"<text values", "<zlib values", "is missing"},
             {"<integer name=\"integer\">", "<integer name=\"whole\">",
              "the state has no integer 'integer'"},
             {">true</flag>", ">yes</flag>", "'flag' is not true or false"},
             {"values=\"3\"", "values=\"4\"", "does not hold 4 values"},
             {"values=\"3\"", "values=\"2\"", "does not hold 2 values"},
             {"values=\"3\"", "values=\"200000000\"", "does not hold"},
             {"<body", "<!-- x --><body", "a name is missing"},
             {"</body>", "</body><x/>", "unknown element 'x'"},
         }) {
        INFO(from << " becomes " << to);
        CHECK_THAT(problem(from, to), has(message));
    }
    std::string deep;
    for (int k = 0; k < 200000; ++k) deep += "<section name=\"s\">";
    CHECK_THAT(problem("<state>", "<state>" + deep), has("nested too deeply"));
    CHECK_THAT(problem("<state>", "<" + std::string(1 << 20, 'x')), has("a name is too long"));
    CHECK_THAT(problem("program=\"1.2.3\"", "program=\"" + std::string(1 << 20, 'x') + "\""),
               has("an attribute is too long"));
}

TEST_CASE("a foreign file is not a restart") {
    Written written;
    for (const std::string& content :
         {std::string(), std::string("hello"), std::string(1 << 21, '\0'),
          std::string("<?xml version=\"1.0\"?>\n<svg/>")}) {
        File::create(written.path).write(content);
        CHECK_THAT(written.problem(), Catch::Contains("it is not a restart file of sphinx"));
    }
    removeFile(written.path);
    CHECK_THAT(written.problem(), Catch::Contains("No such file or directory"));
}

TEST_CASE("a restart that cannot be written leaves the older one") {
    Written written;
    const std::string good = written.content();
    std::filesystem::create_directory(temporaryName(written.path));
    CHECK_THROWS_AS(written.write(RestartEncoding::text), FileError);
    CHECK(written.content() == good);
}
