# SPDX-License-Identifier: MIT
# What tests/README.md says of fuzz_pack, and that a target fails without a packed file that is whole.
#
#   cmake -D EMULATOR=command -D PACK=fuzz_pack -D REPLAY=fuzz_NAME -D SCRATCH=folder -P test_pack.cmake

separate_arguments(emulator UNIX_COMMAND "${EMULATOR}")

# run(STATUS program...): the program must succeed (0) or fail (1).
function(run expected)
  execute_process(COMMAND ${emulator} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT status EQUAL expected)
    message(FATAL_ERROR "${ARGN}: ${status} in place of ${expected}\n${log}")
  endif()
  set(log "${log}" PARENT_SCOPE)
endfunction()

# These files must have the same bytes.
function(same a b)
  file(SHA256 ${a} sum_a)
  file(SHA256 ${b} sum_b)
  if(NOT sum_a STREQUAL sum_b)
    message(FATAL_ERROR "${a} and ${b} differ")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/in ${SCRATCH}/out)
file(WRITE ${SCRATCH}/in/one "one\n")
file(WRITE ${SCRATCH}/in/two "two\r\n")
file(WRITE ${SCRATCH}/in/empty "")
file(WRITE ${SCRATCH}/one "another one\n")
set(file ${SCRATCH}/a.bin)

run(0 ${PACK} add ${file} ${SCRATCH}/in/two)
run(0 ${PACK} add ${file} ${SCRATCH}/in/one ${SCRATCH}/in/empty)
run(0 ${PACK} add ${SCRATCH}/b.bin ${SCRATCH}/in/empty ${SCRATCH}/in/two ${SCRATCH}/in/one)
same(${file} ${SCRATCH}/b.bin)
run(0 ${PACK} unpack ${file} ${SCRATCH}/out)
file(GLOB names RELATIVE ${SCRATCH}/out ${SCRATCH}/out/*)
if(NOT names STREQUAL "empty;one;two")
  message(FATAL_ERROR "unpacked: ${names}")
endif()
foreach(name IN LISTS names)
  same(${SCRATCH}/in/${name} ${SCRATCH}/out/${name})
endforeach()

# What is there already is skipped, under whatever name. What cannot be added leaves the file alone.
file(WRITE ${SCRATCH}/in/three "two\r\n")
run(0 ${PACK} add ${file} ${SCRATCH}/in/three ${SCRATCH}/in/one)
file(WRITE ${SCRATCH}/in/four "four")
run(1 ${PACK} add ${file} ${SCRATCH}/in/four ${SCRATCH}/one)
run(1 ${PACK} add ${file} ${SCRATCH}/in/four ${SCRATCH}/missing)
same(${file} ${SCRATCH}/b.bin)
run(1 ${PACK} unpack ${file} ${SCRATCH}/missing)
run(1 ${PACK} unpack ${SCRATCH}/missing.bin ${SCRATCH}/out)
run(1 ${PACK} unpack ${file})

run(0 ${REPLAY} ${file})
if(NOT log MATCHES "empty\r?\none\r?\ntwo\r?\n5 checks")
  message(FATAL_ERROR "the target ran: ${log}")
endif()
file(WRITE ${SCRATCH}/damaged.bin "fuzzpack, but what follows is nothing of the kind")
foreach(name in/empty in/one damaged.bin)
  run(1 ${REPLAY} ${SCRATCH}/${name})
  run(1 ${PACK} add ${SCRATCH}/${name} ${SCRATCH}/in/four)
endforeach()
run(1 ${REPLAY} ${SCRATCH}/missing.bin)
run(1 ${REPLAY})
