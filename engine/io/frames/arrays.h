// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "io/file/file.h"
#include "io/file/number_type.h"
#include "particles/id_order.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::io {

/// A body and the names of the fields that its frames hold. Every frame has position and id, and
/// mass where the body has one, named or not.
template <int Dim>
struct BodyFrames {
    const bodies::Body<Dim>* body = nullptr;
    std::vector<std::string> fields;
};

/// The fields of a frame besides the position, each once: id, mass, then the named ones.
/// Throws CaseError for a name that the body has no field of.
template <int Dim>
std::vector<const particles::FieldBase*> frameFields(const BodyFrames<Dim>& frames);

/// Values of one field as a file wants them.
struct ArrayCopy {
    NumberType type = NumberType::float64;
    int components = 1;
    AlignedVector<char> values;  ///< `components` a particle, little endian

    std::string_view bytes() const { return {values.data(), values.size()}; }
};

/// How vectors and matrices are laid out.
enum class FieldLayout {
    plain,   ///< Dim components, Dim x Dim row by row
    padded,  ///< 3 components, 3 x 3 row by row; zeros where 2D has nothing (as VTK wants them)
};

/// A field in the layout of a file, particles by ascending id.
template <int Dim>
ArrayCopy copyArray(const particles::FieldBase& field, const particles::IdOrder& order,
                    FieldLayout layout, bool single_precision);

/// What a file has of a field.
struct LastCopy {
    bool taken = false;  ///< by this process, or one that it goes on from
    std::uint64_t fingerprint = 0;
};
/// The same, and remembers it, but nothing where the values are those of the last copy.
template <int Dim>
std::optional<ArrayCopy> copyIfChanged(const particles::FieldBase& field,
                                       const particles::IdOrder& order, FieldLayout layout,
                                       bool single_precision, LastCopy& last);

/// Components of a field in that layout.
template <int Dim>
int componentsOf(particles::Rank rank, FieldLayout layout);

/// Numbers of one particle in these fields.
int componentsOf(const std::vector<const particles::FieldBase*>& fields);

/// Bytes of a frame of these fields in binary.
double frameBytes(const std::vector<const particles::FieldBase*>& fields, std::size_t particles,
                  bool single_precision);

/// Of the values of a field in a file: ids are whole numbers, and places keep their digits.
NumberType numberType(const particles::FieldInfo& info, bool single_precision);

/// Of the values of the field by ascending id, to tell whether it changed.
std::uint64_t fieldFingerprint(const particles::FieldBase& field, const particles::IdOrder& order);

/// "water_000012.vtu"
std::string frameName(std::string_view body, std::int64_t frame, std::string_view extension);
/// Frame number of a name made by frameName, or -1.
std::int64_t frameNumber(std::string_view name, std::string_view body, std::string_view extension);
/// Removes the frames of a body with this number or a later one, and what was left unfinished.
void removeFramesFrom(const Path& folder, std::string_view body, std::string_view extension,
                      std::int64_t first);

}  // namespace sphinx::io
