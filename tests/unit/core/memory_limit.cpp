// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/memory_limit.h"

#include "../temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <string>

using namespace sphinx;

namespace {

/// A folder that stands in for the root of the file system.
class Root {
 public:
    void write(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text << '\n';
    }
    void groups(const std::string& lines) { write("proc/self/cgroup", lines); }
    /// Of a group, by version 2 or 1.
    void limit2(const std::string& group, const std::string& text) {
        write("sys/fs/cgroup" + group + "/memory.max", text);
    }
    void limit1(const std::string& group, const std::string& text) {
        write("sys/fs/cgroup/memory" + group + "/memory.limit_in_bytes", text);
    }
    /// 0 where the machine is the limit.
    double limit() const {
        const MemoryLimit found = memoryLimit(folder_.path());
        REQUIRE(found.bytes > 0);
        REQUIRE(found.bytes <= machine);
        if (!found.of_group) CHECK(found.bytes == machine);
        return found.of_group ? found.bytes : 0;
    }

 private:
    test::TemporaryFolder folder_;
    double machine = memoryLimit(folder_.path()).bytes;
};

}  // namespace

TEST_CASE("without groups of processes memory is that of the machine") {
    Root root;
    CHECK(root.limit() == 0);
    root.groups("0::/");  // the outermost group of version 2 has no file
    CHECK(root.limit() == 0);
    root.groups("no line of this kind\n5:cpu\n\n::\n0::");
    CHECK(root.limit() == 0);
}

TEST_CASE("the limit of a group of version 2 is the least of it and of those around") {
    Root root;
    root.groups("0::/user.slice/user-1.slice/job.scope");
    CHECK(root.limit() == 0);
    root.limit2("/user.slice/user-1.slice/job.scope", "max");
    CHECK(root.limit() == 0);
    root.limit2("/user.slice/user-1.slice/job.scope", "9223372036854771712");
    CHECK(root.limit() == 0);
    root.limit2("/user.slice/user-1.slice/job.scope", "4194304");
    CHECK(root.limit() == 4194304);
    root.limit2("/user.slice/user-1.slice", "8388608");
    CHECK(root.limit() == 4194304);
    root.limit2("/user.slice", "2097152");
    CHECK(root.limit() == 2097152);
    root.limit2("/user.slice/user-1.slice/job.scope", "max");
    root.limit2("/user.slice", "max");
    CHECK(root.limit() == 8388608);
    // Groups beside it, and within it, are others'.
    root.limit2("/user.slice/user-2.slice", "4096");
    root.limit2("/user.slice/user-1.slice/job.scope/within", "4096");
    root.limit1("", "4096");
    CHECK(root.limit() == 8388608);
}

TEST_CASE("the limit of a group of version 1 is that of its controller of memory") {
    Root root;
    root.groups("9:cpu,cpuacct:/other\n4:memory:/batch/job_7\n1:name=memory:/named\n0::/");
    root.limit1("", "9223372036854771712");
    CHECK(root.limit() == 0);
    root.limit1("/batch/job_7", "4194304");
    root.limit1("/other", "4096");
    root.limit1("/named", "4096");
    CHECK(root.limit() == 4194304);
    root.limit1("/batch", "1048576");
    CHECK(root.limit() == 1048576);
    // Both versions at once, each with some controllers.
    root.limit2("", "524288");
    CHECK(root.limit() == 524288);
    // Mounted together with another.
    root.groups("4:cpu,memory:/batch");
    CHECK(root.limit() == 1048576);
}

TEST_CASE("in a container the own group is the outermost that can be seen") {
    Root root;
    SECTION("version 2") {
        root.groups("0::/");
        root.limit2("", "4194304");
        CHECK(root.limit() == 4194304);
    }
    SECTION("version 2, from outside") {
        root.groups("0::/../../job");
        root.limit2("", "4194304");
        CHECK(root.limit() == 4194304);
        root.write("sys/memory.max", "4096");
        root.write("memory.max", "4096");
        CHECK(root.limit() == 4194304);
    }
    SECTION("version 1, with the path of the host") {
        root.groups("4:memory:/docker/0123456789abcdef");
        root.limit1("", "4194304");
        CHECK(root.limit() == 4194304);
    }
}

TEST_CASE("this process has a limit") {
    const MemoryLimit found = memoryLimit();
    CHECK(found.bytes >= 1e6);
    CHECK(found.bytes < 1e18);
}
