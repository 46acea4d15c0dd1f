// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_load.h"

#include "dynamics/known_load.h"
#include "io/series/columns.h"
#include "measure/reduce.h"

#include <algorithm>

namespace sphinx::measure {
namespace {

/// How a kind of load is called in columns and messages.
struct Words {
    std::string column;
    std::string doc;
    std::string missing;  ///< "no method of the loop ..." without the body
};

Words wordsOf(KnownLoads kind) {
    if (kind == KnownLoads::supports)
        return {"reaction", "the constraints", "no method of the loop holds particles of"};
    return {"applied", "the loads from outside", "no method of the loop loads particles of"};
}

/// nullptr when it is no load of that kind.
template <int Dim>
const dynamics::KnownLoad<Dim>* loadOf(const dynamics::Method* method, KnownLoads kind) {
    if (kind == KnownLoads::supports) return dynamic_cast<const dynamics::Support<Dim>*>(method);
    return dynamic_cast<const dynamics::AppliedLoad<Dim>*>(method);
}

}  // namespace

template <int Dim>
std::unique_ptr<io::SeriesSource> makeLoadSource(KnownLoads kind, const bodies::Body<Dim>& body,
                                                 const input::Place& place,
                                                 const io::OutputContext<Dim>& context,
                                                 const std::optional<Vec<Dim>>& about) {
    const Words words = wordsOf(kind);
    std::vector<const dynamics::KnownLoad<Dim>*> loads;
    for (const dynamics::Method* method : context.methods)
        if (const auto* load = loadOf<Dim>(method, kind); load && &load->loaded() == &body)
            loads.push_back(load);
    if (loads.empty()) io::failAt(place, words.missing + " '" + body.name + "'");
    std::vector<io::SeriesQuantity> quantities{{words.column, context.units.text(unit::force),
                                                "force of " + words.doc + " on the body",
                                                io::componentLabels<Dim>(particles::Rank::vector)}};
    if (about)
        quantities.push_back(
            {words.column + "_moment", context.units.text(unit::force * unit::length),
             "moment of " + words.doc + " about the point", io::momentLabels<Dim>()});
    return std::make_unique<ReduceSource>(quantities, [loads, about](std::span<double> row) {
        dynamics::Load<Dim> sum;
        for (const auto* load : loads) sum += load->load();
        std::copy(sum.force.begin(), sum.force.end(), row.begin());
        if (!about) return;
        const dynamics::Moment<Dim> moment =
            sum.moment - dynamics::momentOf<Dim>(*about, sum.force);
        std::copy(moment.begin(), moment.end(), row.begin() + Dim);
    });
}

template std::unique_ptr<io::SeriesSource> makeLoadSource(KnownLoads, const bodies::Body<2>&,
                                                          const input::Place&,
                                                          const io::OutputContext<2>&,
                                                          const std::optional<Vec<2>>&);
template std::unique_ptr<io::SeriesSource> makeLoadSource(KnownLoads, const bodies::Body<3>&,
                                                          const input::Place&,
                                                          const io::OutputContext<3>&,
                                                          const std::optional<Vec<3>>&);

}  // namespace sphinx::measure
