// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/load.h"

#include "core/characters.h"
#include "core/errors.h"
#include "core/read_file.h"
#include "input/tree/overrides.h"
#include "input/tree/yaml.h"

#include <algorithm>
#include <filesystem>

namespace sphinx::input {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 100;

/// The same entry in two files stands for two things that share no keys: components of another
/// type, or shapes, {box: ...} and {difference: ...}.
bool isAnother(const Node& base, const Node& over, bool shape) {
    const Node* old_type = base.find("type");
    const Node* type = over.find("type");
    if (old_type && type) return old_type->text != type->text;
    return shape && base.entries.size() == 1 && over.entries.size() == 1 &&
           base.entries[0].key != over.entries[0].key;
}

/// Values of `over` win; maps merge by key, everything else replaces. `path`: the keys that lead
/// here.
void merge(Node& base, Node over, const std::vector<std::string>& path = {}) {
    const bool shape = path.size() == 2 && path[0] == "geometry";
    if (!base.isMap() || !over.isMap() || isAnother(base, over, shape)) {
        base = std::move(over);
        return;
    }
    base.place = over.place;
    for (Node::Entry& entry : over.entries) {
        const auto present =
            std::find_if(base.entries.begin(), base.entries.end(),
                         [&](const Node::Entry& old) { return old.key == entry.key; });
        if (present == base.entries.end()) {
            base.entries.push_back(std::move(entry));
        } else {
            present->place = entry.place;
            std::vector<std::string> inside = path;
            inside.push_back(entry.key);
            merge(present->value, std::move(entry.value), inside);
        }
    }
}

class Loader {
 public:
    explicit Loader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    Node load(std::string name, std::string text) {
        auto source = std::make_shared<Source>();
        source->folder = fs::path(name).parent_path().string();
        source->name = std::move(name);
        source->text = std::move(text);
        if (source->text.starts_with(byte_order_mark))
            source->text.erase(0, byte_order_mark.size());
        source->order = static_cast<int>(files_.size());
        files_.push_back(source->name);
        Node root = readYaml(source, source->text, {}, diagnostics_);
        if (diagnostics_.hasErrors()) return root;
        if (!root.isMap()) {
            diagnostics_.error({source, root.isNull() ? 0 : root.place.line, root.place.column},
                               root.isNull() ? "the file is empty"
                                             : "a case is a map of blocks (key: value), not " +
                                                   describeNode(root));
            return root;
        }
        return withIncludes(std::move(root), *source);
    }
    const std::vector<std::string>& files() const { return files_; }

 private:
    Node withIncludes(Node root, const Source& source) {
        const auto include =
            std::find_if(root.entries.begin(), root.entries.end(),
                         [](const Node::Entry& entry) { return entry.key == "include"; });
        if (include == root.entries.end()) return root;
        const Node files = std::move(include->value);
        const Place key = include->place;
        root.entries.erase(include);
        if (!files.isList()) {
            diagnostics_.error(files.place,
                               "include must be a list of files, not " + describeNode(files));
            return root;
        }
        open_.push_back(canonical(source.name));
        Node merged = Node::map();
        for (const Node& file : files.items) {
            if (!file.isScalar()) {
                diagnostics_.error(file.place,
                                   "include must be a list of files, not " + describeNode(file));
                continue;
            }
            const fs::path path = fs::path(source.folder) / file.text;
            if (const std::string text = read(path, file.place); !text.empty())
                merge(merged, load(path.lexically_normal().string(), text));
        }
        open_.pop_back();
        merge(merged, std::move(root));
        return merged;
    }

    static fs::path canonical(const fs::path& path) {
        std::error_code ignored;
        return fs::weakly_canonical(path, ignored);
    }

    std::string read(const fs::path& path, const Place& place) {
        const auto found = std::find(open_.begin(), open_.end(), canonical(path));
        if (found != open_.end()) {
            std::string chain;
            for (auto file = found; file != open_.end(); ++file)
                chain += file->filename().string() + " -> ";
            diagnostics_.error(place,
                               "the file includes itself: " + chain + found->filename().string());
            return "";
        }
        if (files_.size() >= most_files) {
            diagnostics_.error(place, "more than " + std::to_string(most_files) + " files");
            return "";
        }
        try {
            std::string text = readFile(path);
            if (text.empty()) diagnostics_.error(place, path.string() + " is empty");
            return text;
        } catch (const FileError& e) {
            diagnostics_.error(place, e.what());
            return "";
        }
    }

    Diagnostics& diagnostics_;
    std::vector<std::string> files_;  // read so far
    std::vector<fs::path> open_;      // files whose includes are being read
};

}  // namespace

LoadedCase loadText(std::string name, std::string text, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, Diagnostics& diagnostics) {
    Loader loader(diagnostics);
    Node root = loader.load(std::move(name), std::move(text));
    if (!diagnostics.hasErrors())
        applyOverrides(root, overrides, named_blocks, static_cast<int>(loader.files().size()),
                       diagnostics);
    return {std::move(root), loader.files()};
}

LoadedCase loadCase(const std::string& path, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, Diagnostics& diagnostics) {
    return loadText(path, readFile(path, 1ULL << 30, FileKinds::pipe_too), overrides, named_blocks,
                    diagnostics);
}

}  // namespace sphinx::input
