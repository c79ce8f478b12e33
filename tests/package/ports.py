# SPDX-License-Identifier: MIT
"""The recipes in cmake/packaging: what vcpkg and conan would make of them, as far as that shows
without these programs. Arguments: the source tree, CMake, an empty directory, the version."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import types
import unittest

SOURCE, CMAKE, SCRATCH, VERSION = sys.argv[1:5]
PACKAGING = os.path.join(SOURCE, "cmake", "packaging")

HEADERS = ("scarp.h", "scarp.hpp")

# The fields of a manifest and of its dependencies, in the reference of vcpkg.json
FIELDS = {"name", "version", "version-semver", "version-date", "version-string", "port-version",
          "description", "homepage", "documentation", "license", "maintainers", "supports",
          "dependencies", "features", "default-features", "overrides", "builtin-baseline",
          "summary", "vcpkg-configuration"}
FEATURE_FIELDS = {"description", "dependencies", "supports", "license"}
DEPENDENCY_FIELDS = {"name", "default-features", "features", "host", "platform", "version>="}
IDENTIFIER = r"[a-z0-9]+(-[a-z0-9]+)*"

# What a portfile may call. Calls are written down, one a line; the options of vcpkg_cmake_configure
# stand for a build.
STAND_INS = """
set(PORT scarp)
set(CMAKE_CURRENT_LIST_DIR ${CURRENT_PORT_DIR})
foreach(name vcpkg_cmake_configure vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_copy_pdbs
        vcpkg_fixup_pkgconfig vcpkg_copy_tools vcpkg_install_copyright)
  cmake_language(EVAL CODE "function(${name})
    file(APPEND \\"\${CALLS}\\" \\"${name} \\${ARGN}\\\\n\\")
  endfunction()")
endforeach()
function(vcpkg_check_features)
  cmake_parse_arguments(arg "" "OUT_FEATURE_OPTIONS" "FEATURES" ${ARGN})
  set(options "")
  while(arg_FEATURES)
    list(POP_FRONT arg_FEATURES feature option)
    if(feature IN_LIST FEATURES)
      list(APPEND options -D${option}=ON)
    else()
      list(APPEND options -D${option}=OFF)
    endif()
  endwhile()
  set(${arg_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()
include(${CURRENT_PORT_DIR}/portfile.cmake)
"""


def options_of_the_project():
    with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
        return set(re.findall(r"^option\((\w+)", file.read(), re.M))


class Vcpkg(unittest.TestCase):
    port = os.path.join(PACKAGING, "vcpkg")

    def manifest(self):
        with open(os.path.join(self.port, "vcpkg.json"), encoding="utf-8") as file:
            return json.load(file)

    def check_dependencies(self, dependencies):
        for dependency in dependencies:
            if isinstance(dependency, str):
                dependency = {"name": dependency}
            self.assertLessEqual(set(dependency), DEPENDENCY_FIELDS)
            self.assertRegex(dependency["name"], f"^{IDENTIFIER}$")

    def test_manifest(self):
        manifest = self.manifest()
        self.assertLessEqual(set(manifest), FIELDS)
        self.assertEqual((manifest["name"], manifest["version"], manifest["license"]),
                         ("scarp", VERSION, "MIT"))
        self.check_dependencies(manifest["dependencies"])
        for name, feature in manifest["features"].items():
            self.assertRegex(name, f"^{IDENTIFIER}$")
            self.assertLessEqual(set(feature), FEATURE_FIELDS)
            self.assertIn("description", feature)
            self.check_dependencies(feature["dependencies"])

    def run_portfile(self, linkage, features):
        calls = os.path.join(SCRATCH, f"calls-{linkage}")
        packages = os.path.join(SCRATCH, f"packages-{linkage}")
        script = os.path.join(SCRATCH, "stand_ins.cmake")
        os.makedirs(os.path.join(packages, "debug", "include"))
        with open(script, "w", encoding="utf-8") as file:
            file.write("cmake_minimum_required(VERSION 3.25)\n" + STAND_INS)
        subprocess.run([CMAKE, "-D", f"CURRENT_PORT_DIR={self.port}", "-D", f"CALLS={calls}",
                        "-D", f"CURRENT_PACKAGES_DIR={packages}", "-D", f"FEATURES={features}",
                        "-D", f"VCPKG_LIBRARY_LINKAGE={linkage}", "-P", script], check=True)
        self.assertFalse(os.path.exists(os.path.join(packages, "debug", "include")))
        self.assertTrue(os.path.exists(os.path.join(packages, "share", "scarp", "usage")))
        with open(calls, encoding="utf-8") as file:
            return dict(line.rstrip("\n").split(" ", 1) for line in file)

    def check_options(self, call):
        arguments = call.split(";")
        self.assertEqual(os.path.realpath(arguments[1]), os.path.realpath(SOURCE))
        options = dict(re.findall(r"-D(\w+)=(\w+)", call))
        self.assertLessEqual(set(options), options_of_the_project())
        return {name: value in ("ON", "1", "TRUE") for name, value in options.items()}

    def test_portfile(self):
        for linkage, features in (("static", ""), ("dynamic", "tools")):
            calls = self.run_portfile(linkage, features)
            options = self.check_options(calls["vcpkg_cmake_configure"])
            self.assertEqual(options, {"BUILD_SHARED_LIBS": linkage == "dynamic",
                                       "SCARP_BUILD_CLI": features == "tools",
                                       "SCARP_BUILD_TESTS": False, "SCARP_BUILD_BENCH": False,
                                       "SCARP_INSTALL": True})
            self.assertEqual("vcpkg_copy_tools" in calls, features == "tools")
            self.assertIn("LICENSE", calls["vcpkg_install_copyright"])


class Namespace(types.SimpleNamespace):
    """Any object of conan's that a recipe sets members of."""

    def set_property(self, name, value):
        setattr(self, name, value)


class Toolchain:
    made = []

    def __init__(self, recipe):
        self.cache_variables = {}

    def generate(self):
        self.made.append(self)


def copy_pattern(_recipe, pattern, source, to):
    """conan's copy, for a file or for all of a folder."""
    path = os.path.join(source, pattern.removesuffix("/*"))
    assert os.path.exists(path), path
    target = os.path.join(to, pattern.removesuffix("/*"))
    if os.path.isdir(path):
        shutil.copytree(path, target)
    else:
        os.makedirs(to, exist_ok=True)
        shutil.copy(path, target)


def load_text(_recipe, path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def import_recipe():
    class Nothing:
        def __init__(self, recipe):
            pass

        def __getattr__(self, name):
            return lambda: None

    def module(name, **members):
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)

    module("conan", ConanFile=object)
    module("conan.tools")
    module("conan.tools.cmake", CMake=Nothing, CMakeDeps=Nothing, CMakeToolchain=Toolchain)
    module("conan.tools.files", copy=copy_pattern, load=load_text, rmdir=lambda recipe, path: None)
    spec = importlib.util.spec_from_file_location(
        "conanfile", os.path.join(PACKAGING, "conan", "conanfile.py"))
    conanfile = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(conanfile)
    return conanfile.ScarpRecipe


class Conan(unittest.TestCase):
    def recipe(self, **options):
        recipe = import_recipe()()
        recipe.recipe_folder = os.path.join(PACKAGING, "conan")
        recipe.options = Namespace(**{**recipe.default_options, **options})
        recipe.settings = Namespace(os="Linux")
        recipe.folders, recipe.cpp_info = Namespace(), Namespace()
        recipe.export_sources_folder = os.path.join(SCRATCH, "exported")
        recipe.source_folder = recipe.export_sources_folder
        recipe.package_folder = os.path.join(SCRATCH, "conan-package")
        return recipe

    def test_version_and_layout(self):
        recipe = self.recipe()
        recipe.set_version()
        self.assertEqual(recipe.version, VERSION)
        recipe.layout()
        self.assertEqual(
            os.path.realpath(os.path.join(recipe.recipe_folder, recipe.folders.root)),
            os.path.realpath(SOURCE))
        self.assertEqual(set(recipe.options.__dict__), set(import_recipe().options))

    def test_options(self):
        for tools in (False, True):
            recipe = self.recipe(tools=tools)
            required = []
            recipe.requires = required.append
            recipe.requirements()
            self.assertEqual(len(required), tools)
            Toolchain.made.clear()
            recipe.generate()
            variables = Toolchain.made[0].cache_variables
            self.assertLessEqual(set(variables), options_of_the_project())
            self.assertEqual(variables["SCARP_BUILD_CLI"], tools)

    def test_what_is_exported_can_be_configured(self):
        recipe = self.recipe()
        recipe.export_sources()
        for name in HEADERS:
            self.assertTrue(os.path.exists(os.path.join(recipe.source_folder, "include", name)))
        build = os.path.join(SCRATCH, "exported-build")
        subprocess.run([CMAKE, "-S", recipe.source_folder, "-B", build, "-DSCARP_BUILD_TESTS=OFF",
                        "-DSCARP_BUILD_BENCH=OFF"], check=True, stdout=subprocess.DEVNULL)
        recipe.build()
        recipe.package()
        self.assertTrue(os.path.exists(os.path.join(recipe.package_folder, "licenses", "LICENSE")))

    def test_package_info(self):
        for shared in (False, True):
            recipe = self.recipe(shared=shared)
            recipe.package_info()
            self.assertEqual(recipe.cpp_info.libs, ["scarp"])
            self.assertEqual(hasattr(recipe.cpp_info, "defines"), shared)
            self.assertEqual(recipe.cpp_info.cmake_target_name, "scarp::scarp")


class Headers(unittest.TestCase):
    def test_headers_are_named(self):
        for name in ("vcpkg/usage", "conan/conanfile.py"):
            text = load_text(None, os.path.join(PACKAGING, name))
            for header in HEADERS:
                self.assertRegex(text, rf"\b{re.escape(header)}\b", name)


class Hosts(unittest.TestCase):
    def test_no_host_is_named(self):
        for folder, _, names in os.walk(PACKAGING):
            for name in names:
                text = load_text(None, os.path.join(folder, name))
                self.assertNotRegex(text, r"https?://|github|gitlab", name)


unittest.main(argv=sys.argv[:1])
