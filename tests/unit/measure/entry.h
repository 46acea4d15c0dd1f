// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../io/support.h"
#include "../scene/entry.h"
#include "../scene/outputs.h"
#include "measure/register.h"

#include <memory>
#include <string>

namespace sphinx::test {

/// An entry of `outputs`.
class Entry {
 public:
    explicit Entry(const std::string& yaml, int dimension = 2) {
        measure::registerMeasures(registry_);
        component_ = readEntry(yaml, input::Kind::output, registry_, dimension);
    }
    template <int Dim>
    std::unique_ptr<Output> make(const io::OutputContext<Dim>& context) const {
        return component_.declaration->builder<io::OutputFactory>().make(component_, context);
    }

 private:
    input::Registry registry_;
    input::Component component_;
};

}  // namespace sphinx::test
