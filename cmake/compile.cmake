# SPDX-License-Identifier: MIT
# How every target of the project is compiled, and where results go.

if(NOT WIN32 OR MINGW)
  set(SCARP_LIBM m)
endif()

# Static libraries have no times and no owners in them, so that the same sources give the same bytes. Some
# systems build ar so that it leaves them out by itself.
if(CMAKE_AR AND NOT APPLE AND NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  execute_process(COMMAND ${CMAKE_AR} --version OUTPUT_VARIABLE ar_version ERROR_QUIET)
  if(ar_version MATCHES "GNU ar|LLVM")
    set(CMAKE_C_ARCHIVE_CREATE "<CMAKE_AR> qcD <TARGET> <LINK_FLAGS> <OBJECTS>")
    set(CMAKE_C_ARCHIVE_APPEND "<CMAKE_AR> qD <TARGET> <LINK_FLAGS> <OBJECTS>")
    set(CMAKE_C_ARCHIVE_FINISH "<CMAKE_RANLIB> -D <TARGET>")
  endif()
endif()

# Messages that consumers of the project see, too: what this build leaves out.
if(MINGW AND CMAKE_C_COMPILER_ID STREQUAL "GNU" AND CMAKE_SIZEOF_VOID_P EQUAL 8)
  message(STATUS "No kernels for AVX2 and AVX-512: gcc for Windows does not align its stack for "
                 "them (GCC bug 54412); clang builds them")
endif()

set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wundef -Wvla -Wconversion -Wstrict-prototypes
             -Wmissing-prototypes)

if(CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  list(TRANSFORM warnings PREPEND /clang:) # -Wall would be every warning there is
endif()

# C11 without extensions, and the same bits everywhere: gcc and clang contract a * b + c into a fused
# multiply-add wherever the target has one, -ffast-math may come from the environment, and on 32-bit
# x86 floats would be computed in wider registers. These flags are target options, so they stand
# after CMAKE_C_FLAGS and win.
function(scarp_compile_rules target)
  set_target_properties(${target} PROPERTIES
    C_STANDARD 11
    C_STANDARD_REQUIRED ON
    C_EXTENSIONS OFF
    C_VISIBILITY_PRESET hidden
    UNITY_BUILD OFF # files are written one by one: names of one are those of others, too
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib
    ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
  target_compile_options(${target} PRIVATE ${warnings} $<$<BOOL:${SCARP_WERROR}>:-Werror>)
  if(MINGW)
    # printf and strtod as C11 has them, and no DLLs of the compiler.
    target_compile_definitions(${target} PRIVATE __USE_MINGW_ANSI_STDIO=1)
    target_link_options(${target} PRIVATE -static)
    if(CMAKE_C_COMPILER_ID STREQUAL "GNU")
      # isnan and isfinite of mingw's headers convert what they do not use.
      target_compile_options(${target} PRIVATE -Wno-float-conversion)
    endif()
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(i.86|x86|x86_64|AMD64)$" AND CMAKE_SIZEOF_VOID_P EQUAL 4)
    target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "s390x" AND CMAKE_C_COMPILER_ID STREQUAL "GNU")
    # With -std=c11, gcc computes floats in double there (FLT_EVAL_METHOD is 1).
    target_compile_options(${target} PRIVATE -fexcess-precision=fast)
  endif()
  if(CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
    target_compile_options(${target} PRIVATE /clang:-fno-fast-math /clang:-ffp-contract=off)
    target_compile_definitions(${target} PRIVATE _CRT_SECURE_NO_WARNINGS _CRT_NONSTDC_NO_WARNINGS)
  else()
    target_compile_options(${target} PRIVATE -fno-fast-math -ffp-contract=off)
    # Linking with -ffast-math adds start-up code that flushes denormals in the whole process.
    target_link_options(${target} PRIVATE -fno-fast-math)
  endif()
endfunction()

# Unoptimised kernels are 20 times slower, and a parent project without a build type, or in Debug,
# would get them without a word. (With gcc 12, -O2 costs kernels 8 % in the mean over all kinds of call
# and up to 70 % of few points, and calls/samples.c 10 % of a point; -Os, which MinSizeRel asks for, 20 %
# and a factor of 3. All else is as fast at -O2. -Os costs nothing that is noticed where texts of shaders and
# descriptions are written, and in some parts of reading recipes; with it in all of these, they are read a
# third slower.)
if(NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  set(optimize -O3)
  set(optimize_hot -O3)
  set(optimize_cold -Os)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    set(optimize -O2)
  endif()
elseif(CMAKE_C_COMPILER_ID MATCHES "Clang")
  set(optimize /clang:-O2)
  set(optimize_hot /clang:-O3)
  set(optimize_cold /clang:-Os)
endif()

# SCARP_SETS as macros of src/dispatch/isas.h: 1 for the sets that are named, 0 for the others.
set(vector_sets avx512 avx2 sse4.1 neon wasm128 generic)
foreach(set IN LISTS SCARP_SETS)
  if(NOT set IN_LIST vector_sets AND NOT set STREQUAL "scalar")
    list(JOIN vector_sets ", " known)
    message(FATAL_ERROR "SCARP_SETS: there is no kernel set ${set}, but scalar, ${known}")
  endif()
endforeach()
set(SCARP_SET_DEFINITIONS)
foreach(set IN LISTS vector_sets)
  if(SCARP_SETS)
    string(TOUPPER ${set} macro)
    string(REPLACE "." "" macro ${macro})
    if(set IN_LIST SCARP_SETS)
      list(APPEND SCARP_SET_DEFINITIONS SCARP_${macro}=1)
    else()
      list(APPEND SCARP_SET_DEFINITIONS SCARP_${macro}=0)
    endif()
  endif()
endforeach()

# What makes kernels larger and no faster: copies of loops and of functions for conditions that stay the
# same, or for arrays without gaps, and padding before branches. Loops over the axes of the reference are
# spelled out: at -O2 alone it takes 20 % more time, and at -O3 it is a quarter larger. (gcc 12; speed is
# within 4 % of -O3 alone, row by row. Measured on x86-64 only; on POWER, the reference at -O2 copied
# numbers of features as floats, which makes signalling NaNs quiet.)
set(vector_options)
set(scalar_options)
# Reading recipes and planning have no use for padding.
set(text_options)
set(hot_recipe_sources coordinates|evaluate|grids|interval|machine|operations|positions|skips)
set(cold_sources change|describe|isa|members|names|noises|places|queries|shader[a-z_]*|summary)
set(no_unwinding)
if(CMAKE_C_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(vector_options -fno-unswitch-loops -fno-split-loops -fno-split-paths -fno-ipa-cp-clone
      -fno-version-loops-for-strides -fno-align-jumps -fno-align-labels)
  set(scalar_options -fpeel-loops -fno-tree-vectorize -fno-ipa-cp -fno-inline-functions
      -fno-align-jumps -fno-align-labels -fno-align-loops --param=max-completely-peeled-insns=400)
  set(text_options -fno-align-functions -fno-align-jumps -fno-align-labels -fno-align-loops)
endif()
# Nothing unwinds through the library, which calls nothing of its callers: the tables would be 20 KB of it.
# Debuggers have those of -g.
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND NOT WIN32 AND NOT APPLE)
  set(no_unwinding -fno-asynchronous-unwind-tables -fno-unwind-tables)
endif()

# The version of the binary interface, which the SONAME and the symbols of the shared library have, so
# that two of them in one process do not mix. While the major version is 0, every minor version may
# change the interface.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(SCARP_ABI 0.${PROJECT_VERSION_MINOR})
else()
  set(SCARP_ABI ${PROJECT_VERSION_MAJOR})
endif()
set(SCARP_MAP ${PROJECT_BINARY_DIR}/scarp.map)
configure_file(cmake/scarp.map.in ${SCARP_MAP} @ONLY)

# What else a build of the library needs; also used for the copies that tests make of it. No compile
# features: they would be looked up in the consumer's directory, which may not know of C.
function(scarp_library_rules target)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(SCARP_OPTIMIZE)
    target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:MinSizeRel>>:${optimize}>)
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    set(options ${no_unwinding})
    if(source MATCHES "/kernels_[a-z0-9]+[.]c$")
      list(APPEND options ${vector_options})
    elseif(source MATCHES "scalar/table[.]c$")
      list(APPEND options ${scalar_options})
    elseif(source MATCHES "/(recipe|plan)/" AND NOT source MATCHES "/(${hot_recipe_sources})[.]c$")
      list(APPEND options ${text_options})
    endif()
    if(source MATCHES "(/kernels_[a-z0-9]+|calls/samples)[.]c$" AND SCARP_OPTIMIZE)
      list(APPEND options $<$<NOT:$<CONFIG:MinSizeRel>>:${optimize_hot}>)
    elseif(source MATCHES "/(${cold_sources})[.]c$" AND SCARP_OPTIMIZE)
      list(APPEND options $<$<NOT:$<CONFIG:MinSizeRel>>:${optimize_cold}>)
    endif()
    set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS ${options})
  endforeach()
  target_compile_definitions(${target} PRIVATE ${SCARP_SET_DEFINITIONS})
  target_link_libraries(${target} PRIVATE ${SCARP_LIBM})
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "SHARED_LIBRARY")
    return()
  endif()
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${SCARP_ABI})
  target_compile_definitions(${target} PRIVATE SCARP_BUILDING_SHARED INTERFACE SCARP_SHARED)
  if(UNIX AND NOT APPLE)
    target_link_options(${target} PRIVATE -Wl,--version-script=${SCARP_MAP})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${SCARP_MAP})
  endif()
endfunction()
