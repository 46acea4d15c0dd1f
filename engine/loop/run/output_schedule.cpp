// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/run/output_schedule.h"

#include <string>
#include <utility>

namespace sphinx::loop {

OutputSchedule::OutputSchedule(const std::vector<OutputEntry>& outputs, LayerRun& outermost)
    : outermost_(outermost) {
    for (const OutputEntry& entry : outputs) {
        EntryRun run{
            entry, Multiples(entry.every ? entry.every->interval : 1), nullptr, false, -1, {}, {}};
        if (entry.every) run.counting = &outermost.find(entry.every->layer)->clock();
        startTrigger(run);
        entries_.push_back(std::move(run));
    }
    connectSampling(outermost);
}

void OutputSchedule::connectSampling(LayerRun& outermost) {
    for (EntryRun& run : entries_) {
        const std::optional<std::string> name = run.entry.output->sampledLayer();
        if (!name) continue;
        LayerRun& layer = *outermost.find(*name);
        // The state after an outermost step is looked at before outputs see it.
        if (&layer == &outermost)
            run.samples_steps = true;
        else
            layer.sampleSubsteps([&run](const Clock& clock) { sample(run, clock); });
    }
}

double OutputSchedule::value(const EntryRun& run) const {
    const Clock& clock = outermost_.clock();
    return run.entry.every->kind == Trigger::Kind::time ? triggerTime(clock.time, clock.dt)
                                                        : static_cast<double>(run.counting->steps);
}

void OutputSchedule::startTrigger(EntryRun& run) const {
    // The wall time begins anew with each process.
    if (!run.entry.every || run.entry.every->kind == Trigger::Kind::wall_time) return;
    run.next.startAfter(value(run));
}

void OutputSchedule::writeFirst() {
    std::vector<bool> due;
    for (const EntryRun& run : entries_)
        due.push_back(!run.entry.restart || run.entry.restart_at_start);
    write(due);
}

void OutputSchedule::sample(EntryRun& run, const Clock& clock) {
    const TimedCall timed(run.tally);
    run.entry.output->sample(clock);
}

void OutputSchedule::writeDue(double wall_seconds, bool last) {
    for (EntryRun& run : entries_)
        if (run.samples_steps) sample(run, outermost_.clock());
    // All triggers move before anything is written: a restart carries the state after this step.
    // In the last step all outputs are due, and the restart knows it.
    std::vector<bool> due(entries_.size());
    bool any = false;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        EntryRun& run = entries_[k];
        due[k] = last;
        if (run.entry.every) {
            const bool wall = run.entry.every->kind == Trigger::Kind::wall_time;
            if (run.next.reach(wall ? wall_seconds : value(run))) due[k] = true;
        }
        any = any || due[k];
    }
    if (any)
        write(due);
    else
        writer_.check();
}

void OutputSchedule::writeLast() { write(std::vector<bool>(entries_.size(), true)); }

void OutputSchedule::writeRestarts() {
    std::vector<bool> due;
    for (const EntryRun& run : entries_) due.push_back(run.entry.restart);
    write(due);
}

void OutputSchedule::syncLater() {
    writer_.add(
        [this] {
            watch_();
            for (EntryRun& run : entries_) run.entry.output->sync();
        },
        0);
}

void OutputSchedule::sync() {
    syncLater();
    writer_.finish();
}

bool OutputSchedule::restartDue(const std::vector<bool>& due) const {
    const std::int64_t now = outermost_.clock().steps;
    for (std::size_t k = 0; k < entries_.size(); ++k)
        if (due[k] && entries_[k].entry.restart && entries_[k].last_step != now) return true;
    return false;
}

void OutputSchedule::write(const std::vector<bool>& due) {
    const Clock& clock = outermost_.clock();
    for (const bool restart : {false, true}) {
        if (restart && restartDue(due)) syncLater();
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            EntryRun& run = entries_[k];
            if (!due[k] || run.entry.restart != restart || run.last_step == clock.steps) continue;
            // Set before: the restart being written must know that it has been.
            run.last_step = clock.steps;
            writeLater(run, clock);
        }
    }
}

void OutputSchedule::writeLater(EntryRun& run, const Clock& clock) {
    const TimedCall timed(run.tally);
    writer_.waitForRoom();
    FileWork work = run.entry.output->take(clock);
    if (!work.write) return;
    writer_.add(
        [this, &run, write = std::move(work.write)] {
            watch_();
            const TimedCall writing(run.writing);
            write();
        },
        work.bytes);
}

void OutputSchedule::resume() {
    for (EntryRun& run : entries_) run.entry.output->resume(outermost_.clock());
}

void OutputSchedule::leaveFolder() {
    for (EntryRun& run : entries_) {
        if (run.entry.restart) run.last_step = -1;
        run.entry.output->leave();
    }
}

void OutputSchedule::finish() {
    writer_.finish();
    for (EntryRun& run : entries_) run.entry.output->finish();
}

void OutputSchedule::transfer(Archive& archive) {
    const Section section(archive, "outputs");
    // What is not saved, or not under the same trigger, goes on from the present time.
    if (archive.loading())
        for (EntryRun& run : entries_) startTrigger(run);
    for (EntryRun& run : entries_)
        if (archive.has(run.entry.name)) transferEntry(archive, run);
}

void OutputSchedule::transferEntry(Archive& archive, EntryRun& run) {
    const Section section(archive, run.entry.name);
    std::string type = run.entry.type;
    archive.value("type", type);
    if (type != run.entry.type) return;

    const std::string present = run.entry.every ? describe(*run.entry.every) : "";
    std::string trigger = present;
    archive.value("every", trigger);
    archive.value("last_step", run.last_step);
    // A changed trigger, and one that counts wall time, start anew.
    Multiples next = run.next;
    next.transfer(archive);
    const bool wall = run.entry.every && run.entry.every->kind == Trigger::Kind::wall_time;
    if (archive.loading() && trigger == present && !wall) run.next = next;
    const Section state(archive, "state");
    run.entry.output->transfer(archive);
}

}  // namespace sphinx::loop
