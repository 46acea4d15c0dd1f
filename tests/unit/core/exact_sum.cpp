// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/exact_sum.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace sphinx;

namespace {

struct Term {
    double a, b;
};

std::vector<Term> randomTerms(double size) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<Term> terms(8 * lane_count);
    for (Term& term : terms) term = {size * any(random), any(random)};
    return terms;
}

template <class F>
void eightByEight(const std::vector<Term>& terms, F&& f) {
    for (std::size_t k = 0; k < terms.size(); k += lane_count) {
        double a[lane_count];
        double b[lane_count];
        for (int n = 0; n < lane_count; ++n) {
            a[n] = terms[k + n].a;
            b[n] = terms[k + n].b;
        }
        f(loadLanes(a), loadLanes(b));
    }
}

double sumOf(const std::vector<Term>& terms, double bound) {
    ExactSum sum{SumGrid(bound)};
    eightByEight(terms, [&](Lanes a, Lanes) { sum.add(a); });
    return sum.value();
}

double sumOfProducts(const std::vector<Term>& terms, double bound) {
    ExactSum sum{SumGrid(bound)};
    eightByEight(terms, [&](Lanes a, Lanes b) { sum.addProduct(a, b); });
    return sum.value();
}

}  // namespace

TEST_CASE("exact sums do not depend on the order of their terms") {
    for (double bound : {1e-20, 0.3, 1.0, 7e9}) {
        std::vector<Term> terms = randomTerms(0.1 * bound);
        const double sum = sumOf(terms, bound);
        const double products = sumOfProducts(terms, bound);
        std::mt19937 random(2);
        for (int k = 0; k < 100; ++k) {
            std::shuffle(terms.begin(), terms.end(), random);
            CHECK(sumOf(terms, bound) == sum);
            CHECK(sumOfProducts(terms, bound) == products);
        }
        for (Term& term : terms) term.a = -term.a;
        CHECK(sumOf(terms, bound) == -sum);
        CHECK(sumOfProducts(terms, bound) == -products);
    }
}

TEST_CASE("terms are rounded to a fine grid") {
    const double bound = 3;
    for (double term : {0.1, -0.7, 1e-9, 2.9}) {
        ExactSum sum{SumGrid(bound)};
        sum.add(Lanes{term});
        CHECK(std::abs(sum.value() - term) <= 4.5e-16 * bound);
        ExactSum product{SumGrid(bound)};
        product.addProduct(Lanes{term}, lanes(0.9));
        CHECK(std::abs(product.value() - 0.9 * term) <= 4.5e-16 * bound);
    }
}

TEST_CASE("sums beyond the bound only lose their independence of the order") {
    const std::vector<Term> terms = randomTerms(1e12);
    double expected = 0;
    for (const Term& term : terms) expected += term.a;
    CHECK(std::abs(sumOf(terms, 1) - expected) < 1e-15 * 1e12 * static_cast<double>(terms.size()));
}
