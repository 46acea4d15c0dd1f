// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/yaml.h"

#include "core/characters.h"
#include "input/tree/yaml_traps.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>
#include <algorithm>
#include <optional>
#include <sstream>
#include <unordered_map>

namespace sphinx::input {
namespace {

constexpr std::size_t deepest = 50;
constexpr std::size_t most_values = 300'000;
constexpr std::size_t most_keys = 10'000;  // of one map

/// Ends the reading of a document after its one message.
struct Refused {
    Place place;
    std::string message;
};

/// Builds our tree from yaml-cpp's events, so that limits apply before memory is used.
class TreeBuilder final : public YAML::EventHandler {
 public:
    TreeBuilder(std::shared_ptr<const Source> source, std::string_view text, Offset offset,
                Diagnostics& diagnostics)
        : source_(std::move(source)), text_(text), offset_(offset), diagnostics_(diagnostics) {}

    Node result;
    int documents = 0;
    /// Where a list or map stands as a key. yaml-cpp also takes an unclosed bracket for one, and
    /// says so only later.
    std::optional<Place> complex_key;

    Place place(const YAML::Mark& mark) const {
        return {source_, mark.line + 1 + offset_.line,
                mark.column + 1 + (mark.line == 0 ? offset_.column : 0)};
    }

    Place place(std::size_t position) const {
        const std::string_view before = text_.substr(0, position);
        const auto lines = std::count(before.begin(), before.end(), '\n');
        const std::size_t begin = lines == 0 ? 0 : before.rfind('\n') + 1;
        return {source_, static_cast<int>(lines) + 1 + offset_.line,
                static_cast<int>(position - begin) + 1 + (lines == 0 ? offset_.column : 0)};
    }
    /// Byte of the innermost bracket that is still open.
    std::optional<std::size_t> openBracket() const {
        for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
            if (frame->node.flow && frame->bracket < text_.size() &&
                (text_[frame->bracket] == '[' || text_[frame->bracket] == '{'))
                return frame->bracket;
        return std::nullopt;
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documents > 1)
            throw Refused{place(mark),
                          "what starts here does not belong to the value before it; a "
                          "file holds one document"};
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        Node node;
        node.place = place(mark);
        if (!frames_.empty() && frames_.back().has_key) node.place = frames_.back().key_place;
        accept(std::move(node), anchor);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        if (wantsKey()) throw Refused{place(mark), "a key cannot be an alias"};
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) throw Refused{place(mark), "an alias inside its own anchor"};
        count(found->second.size, place(mark));
        accept(Node(found->second.node), YAML::NullAnchor);
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        Node node = Node::plain(value);
        node.place = place(mark);
        node.quoted = tag == "!";
        node.flow = !frames_.empty() && frames_.back().node.flow;
        refuseTag(tag, node.place);
        if (!isPlainText(value))
            throw Refused{node.place,
                          "this text has characters that are none to be read, such as "
                          "those that control a terminal"};
        if (node.quoted && !quoteIsClosed(text_, mark.pos))
            throw Refused{node.place, "the quote that opens here is never closed"};
        if (wantsKey())
            acceptKey(std::move(node));
        else
            accept(std::move(node), anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value style) override {
        open(Node::Kind::list, mark, tag, anchor, style);
    }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value style) override {
        open(Node::Kind::map, mark, tag, anchor, style);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapEnd() override { close(); }

 private:
    struct Frame {
        Node node;
        YAML::anchor_t anchor = YAML::NullAnchor;
        std::size_t size_before = 0;
        std::size_t bracket = 0;  // byte where it opens
        bool is_key = false;      // a list or map where a key should be: dropped
        bool has_key = false;
        bool keep = true;  // false: the value of a duplicate key is dropped
        std::string key;
        Place key_place;
    };
    struct Anchored {
        Node node;
        std::size_t size;
    };

    bool wantsKey() const {
        return !frames_.empty() && frames_.back().node.isMap() && !frames_.back().has_key;
    }
    void refuseTag(const std::string& tag, const Place& where) {
        if (tag.empty() || tag == "?" || tag == "!") return;
        diagnostics_.error(where, "tags of YAML (!...) are not part of the language");
    }
    void count(std::size_t values, const Place& where) {
        values_ += values;
        if (values_ > most_values)
            throw Refused{where, "the case has more than " + std::to_string(most_values) +
                                     " values; put long lists into files"};
    }

    void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
              YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
        const Place where = place(mark);
        if (frames_.size() >= deepest)
            throw Refused{where, "nested more than " + std::to_string(deepest) + " deep"};
        refuseTag(tag, where);
        const bool is_key = wantsKey();
        if (is_key && !complex_key) complex_key = where;
        Frame& frame = frames_.emplace_back();
        frame.is_key = is_key;
        frame.node = Node(kind);
        frame.node.place = where;
        frame.node.flow = style == YAML::EmitterStyle::Flow;
        frame.anchor = anchor;
        frame.size_before = values_;
        frame.bracket = static_cast<std::size_t>(mark.pos);
    }
    void close() {
        Frame frame = std::move(frames_.back());
        frames_.pop_back();
        if (frame.is_key) {
            frames_.back().has_key = true;
            frames_.back().keep = false;
            return;
        }
        findSplitExpressions(frame.node, diagnostics_);
        accept(std::move(frame.node), frame.anchor, values_ - frame.size_before);
    }

    void acceptKey(Node key) {
        Frame& frame = frames_.back();
        if (frame.node.entries.size() >= most_keys)
            throw Refused{key.place, "a map with more than " + std::to_string(most_keys) + " keys"};
        frame.has_key = true;
        frame.keep = true;
        if (key.text == "<<" && !key.quoted) {
            diagnostics_.error(key.place,
                               "merge keys (<<) are not part of the language; use include, or "
                               "repeat the value by an alias");
            frame.keep = false;
        } else if (const Node::Entry* first = entry(frame.node, key.text)) {
            diagnostics_.error(key.place, "'" + key.text +
                                              "' is given twice; the first is in line " +
                                              std::to_string(first->place.line));
            frame.keep = false;
        }
        frame.key = std::move(key.text);
        frame.key_place = std::move(key.place);
    }
    static const Node::Entry* entry(const Node& map, const std::string& key) {
        for (const Node::Entry& entry : map.entries)
            if (entry.key == key) return &entry;
        return nullptr;
    }

    void accept(Node node, YAML::anchor_t anchor, std::size_t size = 0) {
        if (wantsKey()) throw Refused{node.place, "a key is missing before the colon"};
        count(1, node.place);
        if (anchor != YAML::NullAnchor) {
            count(size, node.place);  // the copy costs memory too
            anchors_[anchor] = {node, size + 1};
        }
        if (frames_.empty()) {
            result = std::move(node);
            return;
        }
        Frame& frame = frames_.back();
        if (frame.node.isList()) {
            frame.node.items.push_back(std::move(node));
            return;
        }
        frame.has_key = false;
        if (frame.keep)
            frame.node.entries.push_back(
                {std::move(frame.key), std::move(frame.key_place), std::move(node)});
    }

    std::shared_ptr<const Source> source_;
    std::string_view text_;
    Offset offset_;
    Diagnostics& diagnostics_;
    std::vector<Frame> frames_;
    std::unordered_map<YAML::anchor_t, Anchored> anchors_;
    std::size_t values_ = 0;
};

}  // namespace

Node readYaml(const std::shared_ptr<const Source>& source, std::string_view text, Offset offset,
              Diagnostics& diagnostics) {
    if (!checkText(source, text, offset, diagnostics)) return {};
    TreeBuilder builder(source, text, offset, diagnostics);
    try {
        std::istringstream stream{std::string(text)};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
        if (builder.complex_key)
            diagnostics.error(*builder.complex_key, "a key must be a single word");
    } catch (const Refused& refused) {
        diagnostics.error(refused.place, refused.message);
    } catch (const YAML::ParserException& e) {
        const auto [position, message] = explainSyntaxError(
            text, static_cast<std::size_t>(std::max(e.mark.pos, 0)), e.msg, builder.openBracket());
        diagnostics.error(builder.place(position), message);
    }
    return std::move(builder.result);
}

}  // namespace sphinx::input
