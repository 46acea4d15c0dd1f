// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/sources.h"

#include <algorithm>
#include <array>

namespace sphinx::input {

std::span<const Publication> publications() {
    static constexpr std::array all{
        Publication{
            "Adami, Hu & Adams 2013",
            "S. Adami, X. Y. Hu, N. A. Adams, A transport-velocity formulation for smoothed "
            "particle hydrodynamics, J. Comput. Phys. 241, 292-307, 2013",
            "10.1016/j.jcp.2013.01.043"},
        Publication{"Bird, Armstrong & Hassager 1987",
                    "R. B. Bird, R. C. Armstrong, O. Hassager, Dynamics of polymeric liquids, "
                    "volume 1: fluid mechanics, 2nd edition, Wiley, 1987",
                    ""},
        Publication{"Bonet & Lok 1999",
                    "J. Bonet, T.-S. L. Lok, Variational and momentum preservation aspects of "
                    "smooth particle hydrodynamic formulations, Comput. Methods Appl. Mech. Eng. "
                    "180, 97-115, 1999",
                    "10.1016/S0045-7825(99)00051-1"},
        Publication{"Carreau 1972",
                    "P. J. Carreau, Rheological equations from molecular network theories, Trans. "
                    "Soc. Rheol. 16, 99-127, 1972",
                    "10.1122/1.549276"},
        Publication{"Hestenes & Stiefel 1952",
                    "M. R. Hestenes, E. Stiefel, Methods of conjugate gradients for solving linear "
                    "systems, J. Res. Natl. Bur. Stand. 49, 409-436, 1952",
                    "10.6028/jres.049.044"},
        Publication{"Holzapfel & Ogden 2009",
                    "G. A. Holzapfel, R. W. Ogden, Constitutive modelling of passive myocardium: a "
                    "structurally based framework for material characterization, Phil. Trans. R. "
                    "Soc. A 367, 3445-3475, 2009",
                    "10.1098/rsta.2009.0091"},
        Publication{"Jonkman 2007",
                    "J. M. Jonkman, Dynamics modeling and loads analysis of an offshore floating "
                    "wind turbine, NREL/TP-500-41958, 2007",
                    "10.2172/921803"},
        Publication{"Libersky et al. 1993",
                    "L. D. Libersky, A. G. Petschek, T. C. Carney, J. R. Hipp, F. A. Allahdadi, "
                    "High strain Lagrangian hydrodynamics, J. Comput. Phys. 109, 67-75, 1993",
                    "10.1006/jcph.1993.1199"},
        Publication{"Monaghan & Lattanzio 1985",
                    "J. J. Monaghan, J. C. Lattanzio, A refined particle method for astrophysical "
                    "problems, Astron. Astrophys. 149, 135-143, 1985",
                    ""},
        Publication{"Monaghan 1994",
                    "J. J. Monaghan, Simulating free surface flows with SPH, J. Comput. Phys. 110, "
                    "399-406, 1994",
                    "10.1006/jcph.1994.1034"},
        Publication{"Morris, Fox & Zhu 1997",
                    "J. P. Morris, P. J. Fox, Y. Zhu, Modeling low Reynolds number incompressible "
                    "flows using SPH, J. Comput. Phys. 136, 214-226, 1997",
                    "10.1006/jcph.1997.5776"},
        Publication{"Oldroyd 1950",
                    "J. G. Oldroyd, On the formulation of rheological equations of state, Proc. R. "
                    "Soc. Lond. A 200, 523-541, 1950",
                    "10.1098/rspa.1950.0035"},
        Publication{"Papanastasiou 1987",
                    "T. C. Papanastasiou, Flows of materials with yield, J. Rheol. 31, 385-404, "
                    "1987",
                    "10.1122/1.549926"},
        Publication{"Randles & Libersky 1996",
                    "P. W. Randles, L. D. Libersky, Smoothed particle hydrodynamics: some recent "
                    "improvements and applications, Comput. Methods Appl. Mech. Eng. 139, 375-408, "
                    "1996",
                    "10.1016/S0045-7825(96)01090-0"},
        Publication{"Rezavand, Zhang & Hu 2020",
                    "M. Rezavand, C. Zhang, X. Hu, A weakly compressible SPH method for violent "
                    "multi-phase flows with high density ratio, J. Comput. Phys. 402, 109092, 2020",
                    "10.1016/j.jcp.2019.109092"},
        Publication{"Schwager & Poeschel 2007",
                    "T. Schwager, T. Poeschel, Coefficient of restitution and linear-dashpot model "
                    "revisited, Granular Matter 9, 465-469, 2007",
                    "10.1007/s10035-007-0065-z"},
        Publication{
            "Sherman, Seth & Delp 2011",
            "M. A. Sherman, A. Seth, S. L. Delp, Simbody: multibody dynamics for biomedical "
            "research, Procedia IUTAM 2, 241-261, 2011",
            "10.1016/j.piutam.2011.04.023"},
        Publication{"Vignjevic, Reveles & Campbell 2006",
                    "R. Vignjevic, J. R. Reveles, J. Campbell, SPH in a total Lagrangian "
                    "formalism, Comput. Model. Eng. Sci. 14, 181-198, 2006",
                    "10.3970/cmes.2006.014.181"},
        Publication{"Wendland 1995",
                    "H. Wendland, Piecewise polynomial, positive definite and compactly supported "
                    "radial functions of minimal degree, Adv. Comput. Math. 4, 389-396, 1995",
                    "10.1007/BF02123482"},
        Publication{"Zhang, Hu & Adams 2017",
                    "C. Zhang, X. Y. Hu, N. A. Adams, A weakly compressible SPH method based on a "
                    "low-dissipation Riemann solver, J. Comput. Phys. 335, 605-620, 2017",
                    "10.1016/j.jcp.2017.01.027"},
        Publication{"Zhang, Rezavand & Hu 2021",
                    "C. Zhang, M. Rezavand, X. Hu, A multi-resolution SPH method for "
                    "fluid-structure interactions, J. Comput. Phys. 429, 110028, 2021",
                    "10.1016/j.jcp.2020.110028"},
        Publication{"guide",
                    "C. Zhang et al., SPHinXsys User's Guide, version alpha 0.0.0, 2019; its "
                    "methods are published in Comput. Phys. Commun. 267, 108066, 2021",
                    "10.1016/j.cpc.2021.108066"},
    };
    return all;
}

const Publication* findPublication(std::string_view key) {
    const auto all = publications();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Publication& one) { return one.key == key; });
    return found == all.end() ? nullptr : &*found;
}

std::string fullCitation(const Publication& publication) {
    std::string text(publication.text);
    if (!publication.doi.empty()) text += ", doi:" + std::string(publication.doi);
    return text;
}

}  // namespace sphinx::input
