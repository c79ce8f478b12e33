# SPDX-License-Identifier: MIT
# What some tests need besides the compiler: tools, and parts of the project that can be left out.
# A test is always there. Where what it needs is missing, ctest runs test_skip in its place, which
# says so and is reported as skipped; SCARP_REQUIRE_TOOLS in the environment (names from here,
# separated by commas) turns that into a failure.

set(SCARP_WITHOUT_TOOLS "" CACHE STRING "Tools that tests do as if they were missing")
mark_as_advanced(SCARP_WITHOUT_TOOLS)

# scarp_tool(NAME FOUND): FOUND is a path or a condition.
macro(scarp_tool name)
  list(FIND SCARP_WITHOUT_TOOLS ${name} is_without)
  if(is_without LESS 0 AND (${ARGN}))
    list(APPEND scarp_found ${name})
  else()
    list(APPEND scarp_missing ${name})
  endif()
endmacro()

find_package(Python3 COMPONENTS Interpreter QUIET)
# What manages versions of Python may put a script in its place, which starts dozens of processes for
# each of ours.
if(Python3_Interpreter_FOUND)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys; print(sys.executable)"
                  OUTPUT_VARIABLE python RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET)
  if(status EQUAL 0 AND EXISTS "${python}")
    set(Python3_EXECUTABLE ${python})
  endif()
endif()
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads QUIET)
find_program(SCARP_ABIDIFF NAMES abidiff)
find_program(SCARP_ABIDW NAMES abidw)
find_program(SCARP_BASH NAMES bash)
find_program(SCARP_CARGO NAMES cargo)
find_program(SCARP_CHROMIUM NAMES chromium google-chrome chromium-browser)
find_program(SCARP_GIT NAMES git)
find_program(SCARP_GLSLANG NAMES glslangValidator glslang)
find_path(SCARP_GODOT_HEADERS gdextension_interface.h PATH_SUFFIXES godot DOC "The folder of Godot's header")
find_program(SCARP_GROFF NAMES groff)
find_program(SCARP_MCS NAMES mcs)
find_program(SCARP_MONO NAMES mono)
find_program(SCARP_PKG_CONFIG NAMES pkg-config pkgconf)
find_program(SCARP_SH NAMES sh)
find_program(SCARP_SPIRV_DIS NAMES spirv-dis)
find_program(SCARP_SPIRV_OPT NAMES spirv-opt)
find_program(SCARP_STRACE NAMES strace)
find_program(SCARP_VALGRIND NAMES valgrind)
mark_as_advanced(SCARP_ABIDIFF SCARP_ABIDW SCARP_BASH SCARP_CARGO SCARP_CHROMIUM SCARP_GIT SCARP_GLSLANG SCARP_GODOT_HEADERS SCARP_GROFF SCARP_MCS SCARP_MONO
                 SCARP_PKG_CONFIG SCARP_SH
                 SCARP_SPIRV_DIS SCARP_SPIRV_OPT SCARP_STRACE SCARP_VALGRIND)

# The C++ compiler that belongs to the C compiler: g++-12 to gcc-12, aarch64-linux-gnu-g++ to
# aarch64-linux-gnu-gcc. Its headers may be missing.
function(scarp_find_cxx)
  if(CMAKE_CXX_COMPILER)
    set(SCARP_CXX ${CMAKE_CXX_COMPILER} CACHE FILEPATH "The C++ compiler of the tests")
  else()
    get_filename_component(folder ${CMAKE_C_COMPILER} DIRECTORY)
    get_filename_component(name ${CMAKE_C_COMPILER} NAME)
    string(REGEX REPLACE "clang(-[0-9]|$|\\.)" "clang++\\1" name ${name})
    string(REGEX REPLACE "gcc" "g++" name ${name})
    string(REGEX REPLACE "^cc$" "c++" name ${name})
    find_program(SCARP_CXX NAMES ${name} HINTS ${folder} DOC "The C++ compiler of the tests")
  endif()
  mark_as_advanced(SCARP_CXX)
  if(SCARP_CXX)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/cxx.cpp
         "#include <cstdio>\nint main() { return std::puts(\"C++\") < 0; }\n")
    separate_arguments(flags UNIX_COMMAND "${CMAKE_C_FLAGS} ${CMAKE_EXE_LINKER_FLAGS}")
    execute_process(COMMAND ${SCARP_CXX} ${flags} cxx.cpp -o cxx
                    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  endif()
  set(cxx_works OFF PARENT_SCOPE)
  if(SCARP_CXX AND status EQUAL 0)
    set(cxx_works ON PARENT_SCOPE)
  endif()
endfunction()
scarp_find_cxx()

# A Python that has NumPy: that of the tests, or the system's, which has the packages of the system.
function(scarp_find_numpy)
  foreach(python IN ITEMS "${SCARP_NUMPY}" "${Python3_EXECUTABLE}" /usr/bin/python3)
    if(python)
      execute_process(COMMAND ${python} -c "import numpy" RESULT_VARIABLE status
                      OUTPUT_QUIET ERROR_QUIET)
      if(status EQUAL 0)
        set(SCARP_NUMPY ${python} CACHE FILEPATH "A Python that has NumPy" FORCE)
        mark_as_advanced(SCARP_NUMPY)
        return()
      endif()
    endif()
  endforeach()
  unset(SCARP_NUMPY CACHE) # it may come
endfunction()
scarp_find_numpy()

# Whether cargo and its compiler are as new as the crate needs, and of this machine.
function(scarp_find_cargo)
  set(works OFF)
  if(SCARP_CARGO AND NOT CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR
     AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
    get_filename_component(folder ${SCARP_CARGO} DIRECTORY)
    execute_process(COMMAND ${folder}/rustc --version OUTPUT_VARIABLE version
                    RESULT_VARIABLE status ERROR_QUIET)
    if(status EQUAL 0 AND version MATCHES "^rustc ([0-9.]+)" AND CMAKE_MATCH_1 VERSION_GREATER_EQUAL 1.63)
      set(works ON)
    endif()
  endif()
  set(cargo_works ${works} PARENT_SCOPE)
endfunction()
scarp_find_cargo()

# Whether there is a Vulkan device: its driver may be missing where the library is not. Drivers are
# not for programs with instruments in them, nor for emulators.
function(scarp_find_vulkan)
  find_package(Vulkan QUIET)
  set(works OFF)
  if(Vulkan_FOUND AND NOT CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR
     AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
    set(CMAKE_C_STANDARD 11)
    set(CMAKE_TRY_COMPILE_CONFIGURATION Release)
    try_run(status compiled ${CMAKE_CURRENT_BINARY_DIR}/probe
            ${CMAKE_CURRENT_SOURCE_DIR}/gpu/probe.c LINK_LIBRARIES Vulkan::Vulkan)
    if(compiled AND status EQUAL 0)
      set(works ON)
    else()
      unset(status CACHE) # it may come
      unset(compiled CACHE)
    endif()
  endif()
  set(vulkan_works ${works} PARENT_SCOPE)
endfunction()
scarp_find_vulkan()

# Whether the library is optimised, by the project or by the flags of the build type, and has no
# instruments in it.
string(TOUPPER "CMAKE_C_FLAGS_${CMAKE_BUILD_TYPE}" flags_of_type)
set(optimised OFF)
if((SCARP_OPTIMIZE OR "${${flags_of_type}}" MATCHES "-O[1-3]") AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
  set(optimised ON)
endif()

# Whether a browser of this machine tests the shaders, of which other builds say nothing new.
set(browser OFF)
if(SCARP_CHROMIUM AND NOT CMAKE_CROSSCOMPILING AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
  set(browser ON)
endif()

scarp_tool(abidiff SCARP_ABIDIFF AND SCARP_ABIDW)
scarp_tool(bash SCARP_BASH)
scarp_tool(c++ cxx_works)
scarp_tool(cargo cargo_works)
scarp_tool(chromium browser)
scarp_tool(full-speed speed STREQUAL "full")
scarp_tool(git SCARP_GIT)
scarp_tool(glslang SCARP_GLSLANG)
scarp_tool(godot SCARP_GODOT_HEADERS AND UNIX AND NOT CMAKE_CROSSCOMPILING)
scarp_tool(groff SCARP_GROFF)
scarp_tool(linux CMAKE_SYSTEM_NAME STREQUAL "Linux")
scarp_tool(mono SCARP_MCS AND SCARP_MONO AND NOT CMAKE_CROSSCOMPILING
           AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
scarp_tool(nm CMAKE_NM)
scarp_tool(numpy SCARP_NUMPY)
scarp_tool(objdump CMAKE_OBJDUMP)
scarp_tool(optimised optimised)
scarp_tool(pkg-config SCARP_PKG_CONFIG)
scarp_tool(posix UNIX)
scarp_tool(pthreads CMAKE_USE_PTHREADS_INIT)
scarp_tool(python3 Python3_Interpreter_FOUND)
scarp_tool(scarp TARGET scarp-cli)
scarp_tool(scarp-bench TARGET scarp-bench)
scarp_tool(scarp-install SCARP_INSTALL)
scarp_tool(sh SCARP_SH)
scarp_tool(spirv-tools SCARP_SPIRV_DIS)
scarp_tool(strace SCARP_STRACE)
scarp_tool(valgrind SCARP_VALGRIND)
scarp_tool(vulkan vulkan_works)

add_executable(test_skip test_skip.c) # without the library: it says nothing about it
scarp_compile_rules(test_skip)
target_include_directories(test_skip PRIVATE ${PROJECT_SOURCE_DIR}/include)
if(scarp_missing)
  list(JOIN scarp_missing ", " missing)
  message(STATUS "Tests that need these will be skipped: ${missing}")
endif()

# ctest says at its end what was skipped for want of what.
if(PROJECT_IS_TOP_LEVEL)
  file(WRITE ${CMAKE_BINARY_DIR}/CTestCustom.cmake "set(CTEST_CUSTOM_POST_TEST
[==[\"${CMAKE_COMMAND}\" -D \"LOGS=${CMAKE_BINARY_DIR}/Testing/Temporary\" -P \"${CMAKE_CURRENT_SOURCE_DIR}/skipped.cmake\"]==])\n")
endif()
