# SPDX-License-Identifier: MIT
# Runs a fuzz target, linked to libFuzzer: first every input that is kept, then new ones for some time.
# Fails with the path of the input that failed.
#
#   cmake -D PROGRAM=... -D PACK=fuzz_pack -D KEPT=corpus/NAME.bin -D FOUND=folder -D DICTIONARY=file -D LONGEST=bytes
#         -D SECONDS=20 -D SHARE=100 -P run.cmake
#
# SHARE is the percentage of SECONDS that this target runs. With ADD, it adds to KEPT the inputs that such runs have
# found, as far as they reach what none of those that are kept reaches:
#
#   cmake -D PROGRAM=... -D PACK=fuzz_pack -D KEPT=corpus/NAME.bin -D FOUND=folder -D ADD=ON -P run.cmake

# The inputs that are kept, of which a new target has none
file(REMOVE_RECURSE ${FOUND}/kept)
file(MAKE_DIRECTORY ${FOUND}/kept)
if(EXISTS ${KEPT})
  execute_process(COMMAND ${PACK} unpack ${KEPT} ${FOUND}/kept COMMAND_ERROR_IS_FATAL ANY)
endif()
file(GLOB kept ${FOUND}/kept/*)

if(ADD)
  file(GLOB found ${FOUND}/corpus/*)
  if(found)
    execute_process(COMMAND ${PROGRAM} -merge=1 ${FOUND}/kept ${FOUND}/corpus ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB kept ${FOUND}/kept/*)
    execute_process(COMMAND ${PACK} add ${KEPT} ${kept} COMMAND_ERROR_IS_FATAL ANY)
  endif()
  return()
endif()

if(DEFINED ENV{SCARP_FUZZ_SECONDS})
  set(SECONDS $ENV{SCARP_FUZZ_SECONDS})
endif()
if(SECONDS GREATER 0)
  math(EXPR SECONDS "(${SECONDS} * ${SHARE} + 99) / 100")
endif()
foreach(sanitizer ASAN UBSAN)
  if(NOT DEFINED ENV{${sanitizer}_OPTIONS})
    set(ENV{${sanitizer}_OPTIONS} "print_stacktrace=1:detect_stack_use_after_return=1")
  endif()
endforeach()
file(MAKE_DIRECTORY ${FOUND}/corpus ${FOUND}/failed)
set(options -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix=${FOUND}/failed/)

function(run what)
  execute_process(COMMAND ${PROGRAM} ${options} ${ARGN} RESULT_VARIABLE status
                  OUTPUT_VARIABLE log ERROR_VARIABLE log)
  file(WRITE ${FOUND}/log "${log}")
  if(NOT status EQUAL 0)
    string(LENGTH "${log}" length)
    if(length GREATER 12000)
      math(EXPR from "${length} - 12000")
      string(SUBSTRING "${log}" ${from} -1 log)
    endif()
    message("${log}")
    message(FATAL_ERROR "${what}: ${PROGRAM} failed (${status}); the input is in ${FOUND}/failed")
  else()
    set(executions 0)
    if(log MATCHES "stat::number_of_executed_units: *([0-9]+)")
      set(executions ${CMAKE_MATCH_1})
    endif()
    set(coverage)
    string(REGEX MATCHALL "cov: [0-9]+ ft: [0-9]+" covered "${log}")
    if(covered)
      list(GET covered -1 coverage)
    endif()
    message(STATUS "${what}: ${executions} executions; ${coverage}")
  endif()
endfunction()

if(kept)
  run("kept inputs" -runs=0 ${FOUND}/kept)
endif()
if(SECONDS GREATER 0)
  set(more -max_total_time=${SECONDS} -max_len=${LONGEST})
  if(DICTIONARY)
    list(APPEND more -dict=${DICTIONARY})
  endif()
  run("${SECONDS} seconds" ${more} ${FOUND}/corpus ${FOUND}/kept)
endif()
