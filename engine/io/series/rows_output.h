// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "io/output/factory.h"
#include "io/series/series.h"

namespace sphinx::io {

/// Parameters of an output of rows.
struct MeanParameters {
    bool average = false;  ///< rows are means over time
    input::Name layer;     ///< whose substeps are sampled for them; empty: the outermost
};

/// Declares them, for parameters that derive from them.
template <class P>
void declareMeans(input::Declared<P>& declaration) {
    declaration.optional(
        "average", &P::average, input::boolean(),
        "rows are means, over the ends of the steps since the row before and each as long as its "
        "step, instead of values at an instant");
    declaration.optional(
        "layer", &P::layer, input::layerReference(),
        "layer whose steps these are; default: the outermost. At the end of its steps sound in a "
        "fluid is always at the same phase, so means of pressures and forces want the layer that "
        "steps the fluid. That costs as many more looks as it has more steps, and for an observer "
        "each with a new search for neighbors");
    declaration.check("layer", [](const P& p) -> std::string {
        return p.layer.empty() || p.average ? "" : "layer goes with average: true";
    });
}

struct RowsParameters {
    MeanParameters mean;
    /// What the source's state means: a state saved under another form is not loaded, because
    /// outputs are free to change between a run and its resumption.
    std::string form;
};

/// A time series of a source. Its rows are the values at their instant or, with `average`, the
/// means of the values after every step of a layer since the row before, each weighted by the
/// length of its step. Values that are NaN are left out of a mean; a mean of nothing is NaN. The
/// first row, before any step, holds the values themselves. (Rows are written after outermost
/// steps, in which every layer takes at least one.)
class RowsOutput final : public Output {
 public:
    RowsOutput(SeriesParameters series, RowsParameters parameters,
               std::unique_ptr<SeriesSource> source);
    ~RowsOutput() override;

    std::vector<OutputFile> files() const override { return series_.files(); }
    FileWork take(const Clock& clock) override;
    void sync() override { series_.sync(); }
    std::optional<std::string> sampledLayer() const override { return layer_; }
    void sample(const Clock& clock) override;
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;
    void leave() override { series_.leave(); }

 private:
    class Rows;
    RowsOutput(SeriesParameters series, std::optional<std::string> layer,
               std::unique_ptr<Rows> rows);

    std::optional<std::string> layer_;  // that is sampled
    Rows* rows_;                        // owned by the series
    SeriesOutput series_;
};

/// As above, with files named after the entry of the case.
template <int Dim>
std::unique_ptr<Output> makeRowsOutput(const input::Component& component,
                                       const OutputContext<Dim>& context, RowsParameters parameters,
                                       std::unique_ptr<SeriesSource> source);

}  // namespace sphinx::io
