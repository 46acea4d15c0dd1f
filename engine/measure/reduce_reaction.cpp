// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_reaction.h"

#include "dynamics/constraint/support.h"
#include "io/series/columns.h"
#include "measure/reduce.h"

namespace sphinx::io {

template <int Dim>
std::unique_ptr<SeriesSource> makeReactionSource(const Body<Dim>& body, const input::Place& place,
                                                 const OutputContext<Dim>& context) {
    std::vector<const constraint::Support<Dim>*> supports;
    for (const Method* method : context.methods) {
        const auto* support = dynamic_cast<const constraint::Support<Dim>*>(method);
        if (support && &support->supported() == &body) supports.push_back(support);
    }
    if (supports.empty())
        failAt(place, "no method of the loop holds particles of '" + body.name + "'");
    return std::make_unique<ReduceSource>(
        std::vector<SeriesQuantity>{{"reaction", context.units.text(unit::force),
                                     "force of the constraints on the body",
                                     componentLabels<Dim>(Rank::vector)}},
        [supports](std::span<double> row) {
            Vec<Dim> sum = Vec<Dim>::Zero();
            for (const auto* support : supports) sum += support->reaction();
            for (int c = 0; c < Dim; ++c) row[static_cast<std::size_t>(c)] = sum[c];
        });
}

template std::unique_ptr<SeriesSource> makeReactionSource(const Body<2>&, const input::Place&,
                                                          const OutputContext<2>&);
template std::unique_ptr<SeriesSource> makeReactionSource(const Body<3>&, const input::Place&,
                                                          const OutputContext<3>&);

}  // namespace sphinx::io
