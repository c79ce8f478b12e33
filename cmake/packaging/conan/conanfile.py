# SPDX-License-Identifier: MIT
# A recipe of conan 2 for the tree that it lies in: conan create cmake/packaging/conan
"""Packages the library with its headers, scarp.h and (for C++20) scarp.hpp, and the program if the
option `tools` is set."""

import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain
from conan.tools.files import copy, load, rmdir

TREE = os.path.join("..", "..", "..")  # from the recipe to the root of the tree


class ScarpRecipe(ConanFile):
    name = "scarp"
    license = "MIT"
    description = ("Gradient, value, simplex and cellular noise with exact derivatives and the same "
                   "bits on every processor")
    topics = ("noise", "simd", "terrain")
    package_type = "library"
    languages = "C"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False], "tools": [True, False]}
    default_options = {"shared": False, "fPIC": True, "tools": False}
    implements = ["auto_shared_fpic"]

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, TREE, "include", "scarp.h"))
        self.version = ".".join(re.findall(r"#define SCARP_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                                           header))

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, TREE)
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "cmake/*",
                        "include/*", "src/*"):
            copy(self, pattern, tree, self.export_sources_folder)

    def layout(self):
        self.folders.root = TREE
        self.folders.source = "."
        self.folders.build = "build-conan"
        self.folders.generators = os.path.join("build-conan", "generators")

    def requirements(self):
        if self.options.tools:
            self.requires("zlib/[>=1.2.11 <2]")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["SCARP_BUILD_CLI"] = bool(self.options.tools)
        toolchain.cache_variables["SCARP_BUILD_TESTS"] = False
        toolchain.cache_variables["SCARP_BUILD_BENCH"] = False
        toolchain.cache_variables["SCARP_INSTALL"] = True
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        for made_by_conan in ("cmake", "pkgconfig"):
            rmdir(self, os.path.join(self.package_folder, "lib", made_by_conan))

    def package_info(self):
        self.cpp_info.libs = ["scarp"]
        self.cpp_info.set_property("cmake_file_name", "scarp")
        self.cpp_info.set_property("cmake_target_name", "scarp::scarp")
        self.cpp_info.set_property("pkg_config_name", "scarp")
        if self.options.shared:
            self.cpp_info.defines = ["SCARP_SHARED"]
        elif self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["m"]
