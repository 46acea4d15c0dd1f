// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/yaml.h"

#include <catch2/catch.hpp>

using namespace sphinx::input;

namespace {

Node read(const std::string& text, Diagnostics& diagnostics) {
    auto source = std::make_shared<Source>();
    source->name = "case.yaml";
    source->text = text;
    return readYaml(source, source->text, {}, diagnostics);
}

Node read(const std::string& text) {
    Diagnostics diagnostics;
    Node node = read(text, diagnostics);
    INFO(diagnostics.text());
    REQUIRE(!diagnostics.hasErrors());
    return node;
}

}  // namespace

TEST_CASE("Values keep their places") {
    const Node node = read("a: 1\nb:\n  - {c: 'x', d: [2, 3]}\n");
    CHECK(node.find("a")->place.line == 1);
    CHECK(node.find("a")->place.column == 4);
    const Node& item = node.find("b")->items.at(0);
    CHECK(item.place.column == 5);
    CHECK(item.find("c")->quoted);
    CHECK(item.find("c")->text == "x");
    CHECK(item.find("d")->items.at(1).place.column == 21);
    CHECK(item.entries[1].place.column == 14);
}

TEST_CASE("Aliases repeat a value, anchors are kept within limits") {
    const Node node = read("a: &x {b: 1}\nc: *x\n");
    CHECK(node.find("c")->find("b")->text == "1");
    CHECK(node.find("c")->find("b")->place.line == 1);
}

TEST_CASE("Windows line ends and a byte order mark of comments are fine") {
    const Node node = read("a: 1\r\nb: two words\r\n# done\r\n");
    CHECK(node.find("b")->text == "two words");
}

TEST_CASE("What is written reads back the same") {
    Node node = Node::map();
    for (const char* text : {"plain",
                             "with, comma",
                             "with: colon",
                             "with # hash",
                             " blanks ",
                             "-1",
                             "- x",
                             "true",
                             "null",
                             "~",
                             "",
                             "\"quoted\"",
                             "tab\there",
                             "two\nlines",
                             "a ? b : c",
                             "*alias",
                             "&anchor",
                             "[list]",
                             "{map}",
                             "%percent",
                             "@at",
                             "!tag",
                             "|",
                             ">",
                             "a:",
                             ":a",
                             "gr\xC3\xB6\xC3\x9F"
                             "e",
                             "1:30",
                             "...",
                             "---",
                             "?",
                             "? x",
                             "-",
                             "'",
                             "<<",
                             "=",
                             "max(x, y)",
                             "-g",
                             "--g",
                             "- g"}) {
        node.set("key" + std::to_string(node.entries.size()), Node::string(text));
    }
    Node& nested = node.set("list", Node::list());
    nested.add(Node::map()).set("first", Node::number(0.1));
    nested.items[0].set("second", Node::list({Node::number(1e-300), Node::string("x, y")}));
    nested.add(Node::plain("step.action"));
    const Node back = read(writeYaml(node, false));
    REQUIRE(back.entries.size() == node.entries.size());
    for (std::size_t k = 0; k + 1 < node.entries.size(); ++k) {
        INFO(node.entries[k].value.text);
        CHECK(back.entries[k].value.isScalar());
        CHECK(back.entries[k].value.text == node.entries[k].value.text);
    }
    CHECK(writeYaml(back, false) == writeYaml(node, false));
}

TEST_CASE("Origins are comments that do not change the value") {
    Node node = Node::map();
    node.set("a", Node::number(2));
    CHECK(writeYaml(node, true).find("# default") != std::string::npos);
    CHECK(read(writeYaml(node, true)).find("a")->text == "2");
}
