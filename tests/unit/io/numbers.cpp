// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/base64.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"
#include "io/xml/text.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace sphinx;
using namespace sphinx::io;

TEST_CASE("numbers come back bit by bit") {
    std::mt19937_64 random(1);
    for (int k = 0; k < 100000; ++k) {
        // All exponents: denormals, infinities and NaN among them.
        std::uint64_t bits = random();
        if (k % 3 == 0) bits |= 0x7ff0000000000000;
        if (k % 3 == 1) bits &= 0x800fffffffffffff;
        std::string text;
        appendExactNumber(text, std::bit_cast<double>(bits));
        const auto back = parseExactNumber(text);
        REQUIRE(back);
        REQUIRE(std::bit_cast<std::uint64_t>(*back) == bits);
    }
    CHECK(numberText(0.1) == "0.1");
    CHECK(numberText(-0.0) == "-0");
    CHECK(numberText(-std::nan("")) == "nan");
    for (const char* wrong : {"", "nan", "-NaN", "inf", "1 ", " 1", "1,5", "0x12", "1e999", "--1",
                              "0x7ff800000000000g", "0x-ff8000000000001"})
        CHECK_FALSE(parseExactNumber(wrong));
    CHECK(parseInteger("-9223372036854775808") == INT64_MIN);
    for (const char* wrong : {"", "1.0", "9223372036854775808", "+1", "1 "})
        CHECK_FALSE(parseInteger(wrong));
}

TEST_CASE("base64 is that of RFC 4648 and has one text for each value") {
    const std::vector<std::pair<std::string, std::string>> known{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : known) {
        CHECK(encodeBase64(bytes) == text);
        CHECK(decodeBase64(text) == bytes);
    }
    for (const char* wrong : {"Zg", "Zh==", "Zm9=", "====", "Z===", "Zg==Zg==", "Zm 9", "Zm9v\n"})
        CHECK_FALSE(decodeBase64(wrong));
}

TEST_CASE("compressed bytes come back, whatever they look like") {
    std::mt19937_64 random(1);
    std::string noise(300001, ' ');
    for (char& c : noise) c = static_cast<char>(random());
    const std::string flat(300001, 'x');
    for (const std::string& bytes :
         {std::string(), std::string("a"), noise, flat, noise + flat + noise, flat + noise}) {
        const std::string stream = compress(bytes);
        std::string back(bytes.size(), '\0');
        CHECK(decompress(stream, back.data(), back.size()));
        CHECK(back == bytes);
        CHECK_FALSE(decompress(stream + "x", back.data(), back.size()));
        CHECK_FALSE(decompress(stream.substr(1), back.data(), back.size()));
        std::string larger(bytes.size() + 1, '\0');
        CHECK_FALSE(decompress(stream, larger.data(), larger.size()));
        if (!bytes.empty()) CHECK_FALSE(decompress(stream, back.data(), back.size() - 1));
    }
    CHECK(compress(flat).size() < 3000);
    CHECK(compress(noise).size() < noise.size() + 1000);
}

TEST_CASE("a fingerprint changes with every bit and with the order") {
    std::string bytes(1000, '\0');
    const std::uint64_t zero = fingerprint(bytes);
    CHECK(zero != fingerprint(std::string(992, '\0')));
    std::vector<std::uint64_t> seen{zero};
    for (std::size_t k = 0; k < bytes.size(); k += 7) {
        bytes[k] ^= 1;
        seen.push_back(fingerprint(bytes));
        bytes[k] ^= 1;
    }
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

TEST_CASE("XML text") {
    CHECK(escaped("a<b>&\"\r") == "a&lt;b&gt;&amp;&quot;&#13;");
    CHECK(isXmlText("plain \xc3\xa9 \xf0\x9f\x92\xa7\n"));
    for (const std::string& wrong :
         {std::string("\0", 1), std::string("\x1b"), std::string("\xff"), std::string("\xc3"),
          std::string("\xc0\x80"), std::string("\xed\xa0\x80"), std::string("\xef\xbf\xbf")})
        CHECK_FALSE(isXmlText(wrong));
}
