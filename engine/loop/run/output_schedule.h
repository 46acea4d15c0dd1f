// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/writer.h"
#include "loop/run/layer_run.h"

#include <functional>
#include <vector>

namespace sphinx::loop {

/// Decides when each output writes: at the start, after the first outermost step that reaches a
/// multiple of its interval, at the end; never twice at the same step. Lets outputs sample. What
/// they take at their moment is written by another thread while the next steps run; a failure
/// passes through the next call of any function here that writes.
class OutputSchedule {
 public:
    struct EntryRun {
        OutputEntry entry;
        Multiples next;
        const Clock* counting = nullptr;  ///< of the layer whose steps count
        bool samples_steps = false;       ///< after outermost steps
        std::int64_t last_step = -1;      ///< outermost steps at the last write; -1: none yet
        Tally tally;                      ///< of sampling and taking
        Tally writing;                    ///< of writing, on the other thread
    };

    /// The layers will call this object while they run.
    OutputSchedule(const std::vector<OutputEntry>& outputs, LayerRun& outermost);
    OutputSchedule(const OutputSchedule&) = delete;
    OutputSchedule& operator=(const OutputSchedule&) = delete;

    /// Before the first step of a fresh run; restarts wait for the first step.
    void writeFirst();
    /// After an outermost step: lets the outputs sample that do so, then writes those that are due.
    /// `wall_seconds`: since the start of the process. After the last step all are due.
    void writeDue(double wall_seconds, bool last);
    /// At the end: everything that has not written this state yet.
    void writeLast();
    /// A run that is stopped early writes its restarts only: any other frame would be missing in
    /// an uninterrupted run.
    void writeRestarts();
    /// All is written and on the disk.
    void sync();
    /// Called by the thread that writes before each piece of its work; what it throws is a failure.
    void watchWrites(std::function<void()> watch) { watch_ = std::move(watch); }

    /// Tells every output that the run goes on from the present clock.
    void resume();
    /// After transfer(): the run goes on in another folder, in which nothing is written yet.
    void leaveFolder();
    /// All is written, and the outputs know that it was the last.
    void finish();

    const std::vector<EntryRun>& entries() const { return entries_; }

    /// Triggers and the outputs' own state. Outputs are free to change between run and resumption:
    /// a new one starts afresh, a changed trigger goes on from the present time. Load the layers
    /// first.
    void transfer(Archive& archive);

 private:
    double value(const EntryRun& run) const;
    void startTrigger(EntryRun& run) const;
    void transferEntry(Archive& archive, EntryRun& run);
    void connectSampling(LayerRun& outermost);
    static void sample(EntryRun& run, const Clock& clock);
    bool restartDue(const std::vector<bool>& due) const;
    /// Writes the entries of `due` that have not written at this step, restarts last.
    void write(const std::vector<bool>& due);
    void writeLater(EntryRun& run, const Clock& clock);
    void syncLater();

    const LayerRun& outermost_;
    std::vector<EntryRun> entries_;
    std::function<void()> watch_ = [] {};
    Writer writer_;  // ends first: what it does is of the entries
};

}  // namespace sphinx::loop
