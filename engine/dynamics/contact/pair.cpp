// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/pair.h"

#include "core/sum_all.h"

namespace sphinx::dynamics::contact {

template <int Dim>
double Pair<Dim>::nearArea(const Body<Dim>& body) const {
    const auto areaOf = [&](const Surface<Dim>& from, const Surface<Dim>& to,
                            const typename Search<Dim>::Lists& lists) {
        return sumAll(lists.active().size(), [&](std::size_t m) {
            const Index n = lists.active()[m];
            const Vec<Dim> place = from.place(n);
            for (const Index k : lists.of(n))
                if (domain_->difference(place, to.place(k)).norm() <
                    reach_ + from.length(n) + to.length(k))
                    return from.area(n);
            return 0.0;
        });
    };
    double area = 0;
    if (&a_->body() == &body) area += areaOf(*a_, *b_, search_.ofA());
    if (a_ != b_ && &b_->body() == &body) area += areaOf(*b_, *a_, search_.ofB());
    return area;
}

template class Pair<2>;
template class Pair<3>;

}  // namespace sphinx::dynamics::contact
