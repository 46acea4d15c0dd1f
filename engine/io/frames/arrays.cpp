// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/arrays.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"
#include "particles/fields.h"

#include <algorithm>

namespace sphinx::io {
namespace {

/// For each component of the file: the component in memory, or -1 for a zero.
template <int Dim>
std::vector<int> componentMap(particles::Rank rank, FieldLayout layout) {
    const int width = layout == FieldLayout::padded ? 3 : Dim;
    std::vector<int> map;
    if (rank == particles::Rank::vector)
        for (int k = 0; k < width; ++k) map.push_back(k < Dim ? k : -1);
    if (rank == particles::Rank::matrix)
        for (int row = 0; row < width; ++row)
            for (int column = 0; column < width; ++column)
                map.push_back(row < Dim && column < Dim ? column * Dim + row : -1);
    if (map.empty()) map.push_back(0);
    return map;
}

template <class T>
void convert(const double* from, int stride, const std::vector<int>& map,
             const particles::IdOrder& order, T* to) {
    const std::size_t width = map.size();
    parallelRanges(order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const double* source = from + order[k] * static_cast<std::size_t>(stride);
            for (std::size_t c = 0; c < width; ++c)
                to[k * width + c] = map[c] < 0 ? T{0} : static_cast<T>(source[map[c]]);
        }
    });
}

bool unchangedOrder(const std::vector<int>& map) {
    for (std::size_t c = 0; c < map.size(); ++c)
        if (map[c] != static_cast<int>(c)) return false;
    return true;
}

}  // namespace

template <int Dim>
std::vector<const particles::FieldBase*> frameFields(const BodyFrames<Dim>& frames) {
    const particles::ParticleSet<Dim>& particles = frames.body->particles;
    std::vector<const particles::FieldBase*> result{particles.find(fields::id.name)};
    if (const particles::FieldBase* mass = particles.find(fields::mass.name))
        result.push_back(mass);
    for (const std::string& name : frames.fields) {
        const particles::FieldBase* field = particles.find(name);
        if (!field) throw CaseError("body '" + frames.body->name + "' has no field '" + name + "'");
        if (name != fields::position.name &&
            std::find(result.begin(), result.end(), field) == result.end())
            result.push_back(field);
    }
    return result;
}

template <int Dim>
int componentsOf(particles::Rank rank, FieldLayout layout) {
    return static_cast<int>(componentMap<Dim>(rank, layout).size());
}

int componentsOf(const std::vector<const particles::FieldBase*>& fields) {
    int components = 0;
    for (const particles::FieldBase* field : fields) components += field->components();
    return components;
}

double frameBytes(const std::vector<const particles::FieldBase*>& fields, std::size_t particles,
                  bool single_precision) {
    double bytes = 0;
    for (const particles::FieldBase* field : fields)
        bytes += field->components() *
                 static_cast<double>(bytesOf(numberType(field->info(), single_precision)));
    return bytes * static_cast<double>(particles);
}

NumberType numberType(const particles::FieldInfo& info, bool single_precision) {
    if (info.rank == particles::Rank::integer) return NumberType::int64;
    // Far from the origin, places in single precision would fall on each other.
    const bool place =
        info.name == fields::position.name || info.name == fields::initial_position.name;
    return single_precision && !place ? NumberType::float32 : NumberType::float64;
}

template <int Dim>
ArrayCopy copyArray(const particles::FieldBase& field, const particles::IdOrder& order,
                    FieldLayout layout, bool single_precision) {
    ArrayCopy copy;
    copy.type = numberType(field.info(), single_precision);
    const std::vector<int> map = componentMap<Dim>(field.info().rank, layout);
    copy.components = static_cast<int>(map.size());
    const bool single = copy.type == NumberType::float32;
    if (!single && field.components() == copy.components && unchangedOrder(map)) {
        copy.values = order.copy(field);
        return copy;
    }
    copy.values.resize(order.size() * map.size() * bytesOf(copy.type));
    void* target = copy.values.data();
    if (single)
        convert(field.numbers(), field.components(), map, order, static_cast<float*>(target));
    else
        convert(field.numbers(), field.components(), map, order, static_cast<double*>(target));
    return copy;
}

std::uint64_t fieldFingerprint(const particles::FieldBase& field, const particles::IdOrder& order) {
    AlignedVector<char> buffer;
    return fingerprint(order.bytes(field, buffer));
}

template <int Dim>
std::optional<ArrayCopy> copyIfChanged(const particles::FieldBase& field,
                                       const particles::IdOrder& order, FieldLayout layout,
                                       bool single_precision, LastCopy& last) {
    const std::uint64_t now = fieldFingerprint(field, order);
    if (last.taken && now == last.fingerprint) return {};
    last = {true, now};
    return copyArray<Dim>(field, order, layout, single_precision);
}

std::string frameName(std::string_view body, std::int64_t frame, std::string_view extension) {
    std::string number = std::to_string(frame);
    if (number.size() < 6) number.insert(0, 6 - number.size(), '0');
    return std::string(body) + "_" + number + std::string(extension);
}

std::int64_t frameNumber(std::string_view name, std::string_view body, std::string_view extension) {
    const std::size_t around = body.size() + 1 + extension.size();
    if (name.size() < around + 6 || !name.starts_with(body) || name[body.size()] != '_' ||
        !name.ends_with(extension))
        return -1;
    const std::string_view digits = name.substr(body.size() + 1, name.size() - around);
    if (digits.find_first_not_of("0123456789") != digits.npos) return -1;
    return parseInteger(digits).value_or(-1);
}

void removeFramesFrom(const Path& folder, std::string_view body, std::string_view extension,
                      std::int64_t first) {
    std::error_code error;
    std::vector<Path> beyond;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        std::string name = entry.path().filename().string();
        const std::string unfinished = temporaryName("").string();
        const bool complete = !name.ends_with(unfinished);
        if (!complete) name.resize(name.size() - unfinished.size());
        const std::int64_t number = frameNumber(name, body, extension);
        if (number >= (complete ? first : 0)) beyond.push_back(entry.path());
    }
    for (const Path& path : beyond) removeFile(path);
}

template std::vector<const particles::FieldBase*> frameFields(const BodyFrames<2>&);
template std::vector<const particles::FieldBase*> frameFields(const BodyFrames<3>&);
template int componentsOf<2>(particles::Rank, FieldLayout);
template int componentsOf<3>(particles::Rank, FieldLayout);
template ArrayCopy copyArray<2>(const particles::FieldBase&, const particles::IdOrder&, FieldLayout,
                                bool);
template ArrayCopy copyArray<3>(const particles::FieldBase&, const particles::IdOrder&, FieldLayout,
                                bool);
template std::optional<ArrayCopy> copyIfChanged<2>(const particles::FieldBase&,
                                                   const particles::IdOrder&, FieldLayout, bool,
                                                   LastCopy&);
template std::optional<ArrayCopy> copyIfChanged<3>(const particles::FieldBase&,
                                                   const particles::IdOrder&, FieldLayout, bool,
                                                   LastCopy&);

}  // namespace sphinx::io
