// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "core/clock.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sphinx {

/// A file, or a series of files, that an output writes.
struct OutputFile {
    std::string name;  ///< in the results folder; "*" stands for a number
    double bytes = 0;  ///< that one write adds, before compression; 0: nothing that stays
};

/// Writes a state that was taken before.
struct FileWork {
    std::function<void()> write;  ///< empty: there is nothing to write
    std::size_t bytes = 0;        ///< of memory that it holds, about
};

/// One entry of `outputs`. It reads particles and writes files; it never changes the physics and
/// never a time step.
class Output {
 public:
    virtual ~Output() = default;

    /// What it writes; no two outputs of a run may write the same.
    virtual std::vector<OutputFile> files() const { return {}; }
    /// Takes what is to be written of the state at clock.time (clock.steps outermost steps are
    /// complete). The particles may then change: the work, which throws FileError, is done once, by
    /// another thread perhaps, after what was taken before it and before sync() and finish(). What
    /// transfer() saves is known when this returns.
    virtual FileWork take(const Clock& clock) = 0;
    /// Both at once.
    void write(const Clock& clock) {
        if (const FileWork work = take(clock); work.write) work.write();
    }
    /// Before a restart that counts on what is written: the disk has it. By the thread that writes.
    virtual void sync() {}
    /// The layer after each of whose substeps sample() is called (time averages), with that layer's
    /// clock: its name, empty for the outermost, or nothing for an output that never samples. After
    /// an outermost step all sample before any writes.
    virtual std::optional<std::string> sampledLayer() const { return {}; }
    virtual void sample(const Clock&) {}
    /// State that a restart must carry (frames written so far, running means). A resumed run goes
    /// on in the same files, without writing a frame twice.
    virtual void transfer(Archive&) {}
    /// Before the first write of a run that goes on in its folder: drops from the files whatever
    /// was written after the state that is being resumed (clock), so that nothing appears twice.
    virtual void resume(const Clock&) {}
    /// Instead of it where the run goes on in another folder, in which it has written nothing yet.
    virtual void leave() {}
    /// Called once when all is written.
    virtual void finish() {}
};

}  // namespace sphinx
