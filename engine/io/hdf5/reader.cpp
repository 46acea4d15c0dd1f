// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/reader.h"

#include "core/errors.h"

#include <hdf5.h>

namespace sphinx::io::hdf5 {
namespace {

/// Closes what the library opened.
class Handle {
 public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }

 private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

herr_t collectLink(hid_t group, const char* name, const H5L_info_t* info, void* links) {
    if (info->type != H5L_TYPE_HARD) return -1;
    H5O_info_t object;
    if (H5Oget_info_by_name2(group, name, &object, H5O_INFO_BASIC, H5P_DEFAULT) < 0) return -1;
    static_cast<std::vector<Link>*>(links)->push_back({name, object.addr});
    return 0;
}

}  // namespace

Reader::Reader(const Path& path) : path_(path) {
    // The library would print every failure to the terminal; ours are exceptions.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0) throw FileError("cannot read " + path.string() + ": it is not an HDF5 file");
}

Reader::~Reader() { H5Fclose(file_); }

void Reader::fail(const std::string& object) const {
    throw FileError("cannot continue " + path_.string() + ": " + object +
                    " in it is missing or not as sphinx wrote it");
}

bool Reader::has(const std::string& object) const {
    // Each part of the path has to be asked for by itself.
    for (std::size_t end = object.find('/', 1);; end = object.find('/', end + 1)) {
        if (H5Lexists(file_, object.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == object.npos) return true;
    }
}

std::vector<Link> Reader::members(const std::string& group) const {
    const Handle id(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
    std::vector<Link> links;
    if (id < 0 || H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, collectLink, &links) < 0)
        fail(group);
    return links;
}

template <class T>
std::vector<T> Reader::values(const std::string& dataset, std::int64_t type) const {
    const Handle id(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (id < 0) fail(dataset);
    const Handle space(H5Dget_space(id), H5Sclose);
    const hssize_t count = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
    // What is not in the file would read as zeros: an extent beyond it is not ours.
    if (count < 0 || static_cast<std::uint64_t>(count) * sizeof(T) > File::openRead(path_).size())
        fail(dataset);
    std::vector<T> result(static_cast<std::size_t>(count));
    if (count > 0 && H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) < 0)
        fail(dataset);
    return result;
}

std::vector<double> Reader::numbers(const std::string& dataset) const {
    return values<double>(dataset, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Reader::integers(const std::string& dataset) const {
    return values<std::int64_t>(dataset, H5T_NATIVE_INT64);
}

StoredArray Reader::array(const std::string& dataset) const {
    const Handle id(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (id < 0) fail(dataset);
    const Handle space(H5Dget_space(id), H5Sclose);
    const Handle type(H5Dget_type(id), H5Tclose);
    const Handle creation(H5Dget_create_plist(id), H5Pclose);
    if (space < 0 || type < 0 || creation < 0) fail(dataset);

    StoredArray result;
    if (H5Tequal(type, H5T_IEEE_F64LE) > 0)
        result.type = Number::float64;
    else if (H5Tequal(type, H5T_IEEE_F32LE) > 0)
        result.type = Number::float32;
    else if (H5Tequal(type, H5T_STD_I64LE) > 0)
        result.type = Number::int64;
    else
        fail(dataset);

    constexpr int most_dimensions = 3;
    const int rank = H5Sget_simple_extent_ndims(space);
    hsize_t extent[most_dimensions], chunk[most_dimensions];
    if (rank < 1 || rank > most_dimensions || H5Pget_layout(creation) != H5D_CHUNKED ||
        H5Sget_simple_extent_dims(space, extent, nullptr) != rank ||
        H5Pget_chunk(creation, rank, chunk) != rank)
        fail(dataset);
    for (int d = 1; d < rank; ++d)
        if (chunk[d] != extent[d]) fail(dataset);
    result.rows = extent[0];
    result.row_shape.assign(extent + 1, extent + rank);
    result.chunk_rows = static_cast<std::uint32_t>(chunk[0]);
    result.filtered = H5Pget_nfilters(creation) > 0;
    hsize_t offset[most_dimensions]{};
    for (; offset[0] < extent[0]; offset[0] += chunk[0]) {
        unsigned mask = 0;
        haddr_t address = HADDR_UNDEF;
        hsize_t bytes = 0;
        if (H5Dget_chunk_info_by_coord(id, offset, &mask, &address, &bytes) < 0 ||
            address == HADDR_UNDEF)
            fail(dataset);
        result.chunks.push_back({address, static_cast<std::uint32_t>(bytes)});
    }
    return result;
}

}  // namespace sphinx::io::hdf5
