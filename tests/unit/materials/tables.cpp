// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "support.h"

#include <Eigen/LU>

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace sphinx;
using namespace sphinx::materials;

namespace {

struct Row {
    std::unique_ptr<ElasticSolid> solid;
    std::vector<double> values;
};

std::unique_ptr<ElasticSolid> solidOf(const std::string& law) {
    if (law == "SVK") return std::make_unique<SaintVenantKirchhoff>(isotropicParameters());
    if (law == "NH") return std::make_unique<NeoHookean>(isotropicParameters());
    if (law == "FE_Jm3") return std::make_unique<FiniteExtensibility>(extensibleParameters());
    if (law == "HO") return std::make_unique<HolzapfelMuscle>(muscleParameters());
    return nullptr;
}

/// Rows of a table, first column the law; lines of comment and the header are left out.
std::vector<Row> readTable(const std::string& name) {
    std::ifstream file(std::string(SPHINX_TEST_DATA) + "/" + name);
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::string cell;
        std::getline(cells, cell, ',');
        Row row{solidOf(cell), {}};
        if (!row.solid) continue;
        while (std::getline(cells, cell, ',')) row.values.push_back(std::stod(cell));
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The tables have ten digits and are in units of E.
Approx near(double expected) { return Approx(expected).epsilon(1e-9).margin(1e-9); }

template <int Dim>
struct Stresses {
    Mat<Dim> second;  ///< S
    Mat<Dim> first;   ///< P = F S
    Mat<Dim> cauchy;  ///< F S F^T/J
};

template <int Dim>
Stresses<Dim> stresses(const ElasticSolid& solid, const Mat<Dim>& F) {
    const Mat<Dim> S = stress<Dim>(solid, rightCauchyGreen<Dim>(F), alongAxes<Dim>());
    return {S, F * S, F * S * F.transpose() / F.determinant()};
}

/// Transverse stretches without transverse stress, by Newton steps from the tabulated ones, whose
/// last digit is too coarse to be put into F.
template <int Dim>
Vec<Dim> relaxed(const ElasticSolid& solid, Vec<Dim> stretch) {
    const auto transverse = [&](const Vec<Dim>& l) -> Vec<Dim - 1> {
        const Mat<Dim> C = l.cwiseAbs2().asDiagonal();
        return stress<Dim>(solid, C, alongAxes<Dim>()).diagonal().template tail<Dim - 1>();
    };
    for (int step = 0; step < 4; ++step) {
        Mat<Dim - 1> slope;
        for (int k = 1; k < Dim; ++k) {
            const Vec<Dim> shift = 1e-5 * Vec<Dim>::Unit(k);
            slope.col(k - 1) = (transverse(stretch + shift) - transverse(stretch - shift)) / 2e-5;
        }
        stretch.template tail<Dim - 1>() -= slope.inverse() * transverse(stretch);
    }
    return stretch;
}

/// check(solid, values) for each row of a table that has so many.
template <class Check>
void forRows(const std::string& file, std::size_t count, Check check) {
    const auto rows = readTable(file);
    REQUIRE(rows.size() == count);
    for (const Row& row : rows) {
        INFO("law " << nameOf(*row.solid) << ", stretch or shear " << row.values[0]);
        check(*row.solid, row.values);
    }
}

/// S and the stress of Cauchy have these values on their diagonals.
template <int Dim>
void checkDiagonals(const Stresses<Dim>& found, const double* second, const double* cauchy) {
    for (int k = 0; k < Dim; ++k) {
        CHECK(found.second(k, k) == near(second[k]));
        CHECK(found.cauchy(k, k) == near(cauchy[k]));
    }
}

/// S, P and the stress of Cauchy along the axis; across it there is none.
template <int Dim>
void checkUniaxial(const Stresses<Dim>& found, const double* along) {
    CHECK(found.second(0, 0) == near(along[0]));
    CHECK(found.first(0, 0) == near(along[1]));
    CHECK(found.cauchy(0, 0) == near(along[2]));
    for (int k = 1; k < Dim; ++k) CHECK(found.cauchy(k, k) == near(0));
}

}  // namespace

TEST_CASE("uniaxial stress agrees with the table") {
    forRows("solid_uniaxial_stress_3d.csv", 63,
            [](const ElasticSolid& solid, const std::vector<double>& v) {
                const Vec<3> l = relaxed<3>(solid, Vec<3>(v[0], v[1], v[2]));
                CHECK(l[1] == near(v[1]));
                CHECK(l[2] == near(v[2]));
                const Mat<3> F = l.asDiagonal();
                const auto s = stresses<3>(solid, F);
                checkUniaxial(s, &v[3]);
            });
}

TEST_CASE("uniaxial stress in plane strain agrees with the table") {
    forRows("solid_uniaxial_stress_planestrain.csv", 46,
            [](const ElasticSolid& solid, const std::vector<double>& v) {
                const Vec<2> l = relaxed<2>(solid, Vec<2>(v[0], v[1]));
                CHECK(l[1] == near(v[1]));
                const Mat<2> F = l.asDiagonal();
                const auto s = stresses<2>(solid, F);
                checkUniaxial(s, &v[2]);
                const Mat<3> F3 = Vec<3>(l[0], l[1], 1).asDiagonal();
                CHECK(stresses<3>(solid, F3).cauchy(2, 2) == near(v[5]));
            });
}

TEST_CASE("uniaxial strain agrees with the table") {
    forRows("solid_uniaxial_strain.csv", 63,
            [](const ElasticSolid& solid, const std::vector<double>& v) {
                const Mat<3> F = Vec<3>(v[0], 1, 1).asDiagonal();
                const auto s = stresses<3>(solid, F);
                const Mat<2> plane = F.topLeftCorner<2, 2>();
                const auto p = stresses<2>(solid, plane);
                checkDiagonals(s, &v[1], &v[4]);
                for (int k = 0; k < 2; ++k)
                    CHECK(p.second(k, k) == near(v[static_cast<std::size_t>(1 + k)]));
            });
}

TEST_CASE("simple shear agrees with the table") {
    forRows("solid_simple_shear.csv", 52,
            [](const ElasticSolid& solid, const std::vector<double>& v) {
                Mat<3> F = Mat<3>::Identity();
                F(0, 1) = v[0];
                const auto s = stresses<3>(solid, F);
                checkDiagonals(s, &v[1], &v[5]);
                CHECK(s.second(0, 1) == near(v[4]));
                CHECK(s.cauchy(0, 1) == near(v[8]));
                CHECK(s.first(0, 1) == near(v[9]));
                CHECK(s.first(1, 0) == near(v[10]));
                const Mat<2> plane = F.topLeftCorner<2, 2>();
                const auto p = stresses<2>(solid, plane);
                CHECK(p.second(0, 0) == near(v[1]));
                CHECK(p.second(1, 1) == near(v[2]));
                CHECK(p.second(0, 1) == near(v[4]));
            });
}
