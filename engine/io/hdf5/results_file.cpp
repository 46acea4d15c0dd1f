// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/results_file.h"

#include "io/hdf5/reader.h"

namespace sphinx::io {

using namespace hdf5;

Attributes attributesOf(const Provenance& provenance) {
    Attributes attributes;
    for (const auto& [name, value] : provenance.entries) attributes.push_back({name, value});
    return attributes;
}

void ResultsFile::makeGroups() {
    root_.setAttributes(attributesOf(provenance_));
    bodies_ = root_.put("bodies", std::make_shared<Group>());
    series_ = root_.put("series", std::make_shared<Group>());
}

void ResultsFile::open() {
    if (file_) return;
    file_ = SafeFile::create(path_);
    makeGroups();
}

void ResultsFile::resume() {
    if (file_) return;
    if (!isThere(path_)) {
        open();
        return commit(true);
    }
    file_ = SafeFile::open(path_);
    makeGroups();
    const Reader reader(path_);
    for (const auto& [name, group] : {std::pair("bodies", bodies_), std::pair("series", series_)})
        if (reader.has(name))
            for (const Link& link : reader.members(name))
                group->put(link.name, std::make_shared<StoredNode>(link.address));
}

}  // namespace sphinx::io
