// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/provenance.h"
#include "io/hdf5/nodes.h"

#include <optional>

namespace sphinx::io {

/// results.h5, shared by the outputs that write to it: groups `bodies` (frames of particles) and
/// `series` (observers and reductions), provenance as attributes of the root group.
class ResultsFile {
 public:
    ResultsFile(const Path& path, Provenance provenance)
        : path_(path), provenance_(std::move(provenance)) {}

    const Path& path() const { return path_; }
    /// Creates the file, if nobody has created or continued it yet. FileError if it exists.
    void open();
    /// Goes on with the existing file, if nobody has yet: everything in it stays until somebody
    /// puts something else in its place. Without such a file the same as open().
    void resume();

    hdf5::Group& bodies() { return *bodies_; }
    hdf5::Group& series() { return *series_; }
    hdf5::SafeFile& file() { return *file_; }
    void commit(bool durable) { hdf5::commit(*file_, root_, durable); }

 private:
    void makeGroups();

    Path path_;
    Provenance provenance_;
    std::optional<hdf5::SafeFile> file_;
    hdf5::Group root_;
    std::shared_ptr<hdf5::Group> bodies_, series_;
};

/// Provenance as attributes.
hdf5::Attributes attributesOf(const Provenance& provenance);

}  // namespace sphinx::io
