// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/linear_algebra.h"

#include <dlfcn.h>

#include <filesystem>

namespace sphinx::dynamics::multibody {
namespace {

template <class Function>
Function* symbol(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Folder and file that a symbol is loaded from, links followed: alternatives of a system are links
/// of one name.
std::string fileOf(const char* name) {
    Dl_info info;
    const void* address = dlsym(RTLD_DEFAULT, name);
    if (!address || dladdr(address, &info) == 0 || !info.dli_fname) return "unknown";
    std::error_code error;
    const std::filesystem::path path = std::filesystem::canonical(info.dli_fname, error);
    if (error) return info.dli_fname;
    return (path.parent_path().filename() / path.filename()).string();
}

}  // namespace

std::string linearAlgebra() {
    const std::string lapack = fileOf("dgelss_"), blas = fileOf("dgemm_");
    std::string name = lapack == blas ? lapack : lapack + ", " + blas;
    if (const auto configuration = symbol<char*()>("openblas_get_config"))
        name += std::string(", ") + configuration();
    return name;
}

void keepLinearAlgebraToOneThread() {
    for (const char* name :
         {"openblas_set_num_threads", "MKL_Set_Num_Threads", "bli_thread_set_num_threads"})
        if (const auto set = symbol<void(int)>(name)) set(1);
}

}  // namespace sphinx::dynamics::multibody
