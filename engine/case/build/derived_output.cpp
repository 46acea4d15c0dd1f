// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/derived_output.h"

#include "dynamics/solid/derived_fields.h"
#include "input/declaration/declaration.h"
#include "materials/elastic_solid.h"

#include <algorithm>

namespace sphinx::build {
namespace {

template <int Dim>
class DerivedOutput final : public Output {
 public:
    DerivedOutput(std::unique_ptr<Output> output, DerivedFields<Dim> fields)
        : output_(std::move(output)), fields_(std::move(fields)) {}

    std::vector<OutputFile> files() const override { return output_->files(); }
    FileWork take(const Clock& clock) override {
        fields_.refresh();
        return output_->take(clock);
    }
    std::optional<std::string> sampledLayer() const override { return output_->sampledLayer(); }
    void sample(const Clock& clock) override {
        fields_.refresh();
        output_->sample(clock);
    }
    void transfer(Archive& archive) override { output_->transfer(archive); }
    void resume(const Clock& clock) override { output_->resume(clock); }
    void leave() override { output_->leave(); }
    void sync() override { output_->sync(); }
    void finish() override { output_->finish(); }

 private:
    std::unique_ptr<Output> output_;
    DerivedFields<Dim> fields_;
};

}  // namespace

template <int Dim>
DerivedFields<Dim>::DerivedFields(const input::Component& output, bodies::World<Dim>& world) {
    for (const input::Parameter& parameter : output.declaration->parameters())
        for (const input::Name& name : output.references(parameter)) {
            const particles::FieldInfo* field = fields::find(name.text);
            if (field && field->kind == particles::FieldKind::derived &&
                std::find(fields_.begin(), fields_.end(), field) == fields_.end())
                fields_.push_back(field);
        }
    if (fields_.empty()) return;
    for (auto& body : world.bodies) {
        if (!body->isElastic()) continue;
        bodies_.push_back(body.get());
        for (const particles::FieldInfo* field : fields_) body->particles.require(*field);
    }
}

template <int Dim>
void DerivedFields<Dim>::refresh() const {
    for (bodies::Body<Dim>* body : bodies_)
        for (const particles::FieldInfo* field : fields_) dynamics::solid::derive(*body, *field);
}

template <int Dim>
std::unique_ptr<Output> withDerivedFields(std::unique_ptr<Output> output,
                                          DerivedFields<Dim> fields) {
    if (fields.empty()) return output;
    return std::make_unique<DerivedOutput<Dim>>(std::move(output), std::move(fields));
}

template class DerivedFields<2>;
template class DerivedFields<3>;
template std::unique_ptr<Output> withDerivedFields(std::unique_ptr<Output>, DerivedFields<2>);
template std::unique_ptr<Output> withDerivedFields(std::unique_ptr<Output>, DerivedFields<3>);

}  // namespace sphinx::build
