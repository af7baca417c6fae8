# lares_library(NAME SOURCES … DEPENDS … PRIVATE_DEPENDS …): one folder, one library.
add_library(lares_flags INTERFACE)
target_compile_options(lares_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                             -Woverloaded-virtual -Wno-missing-field-initializers)
if(LARES_WERROR)
  target_compile_options(lares_flags INTERFACE -Werror)
endif()
if(LARES_SANITIZE)
  add_compile_options(-fsanitize=${LARES_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${LARES_SANITIZE})
  # GCC 12 warns of its own <regex> then.
  target_compile_options(lares_flags INTERFACE -Wno-maybe-uninitialized)
endif()
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

function(lares_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(${NAME} STATIC ${ARG_SOURCES})
  target_include_directories(${NAME} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PUBLIC ${ARG_DEPENDS} PRIVATE lares_flags ${ARG_PRIVATE_DEPENDS})
endfunction()

# lares_test(NAME SOURCES … DEPENDS …): a GoogleTest program, run by ctest as NAME.
# Tests find the project's own files through LARES_SOURCE_DIR and outside data through LARES_DATA.
function(lares_test NAME)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE lares_flags ${ARG_DEPENDS} GTest::gtest GTest::gmock
                                        GTest::gtest_main)
  target_compile_definitions(${NAME} PRIVATE LARES_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${NAME} COMMAND ${NAME})
  set_tests_properties(${NAME} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()

# lares_fuzzer(NAME SOURCE DEPENDS …): a reader's LLVMFuzzerTestOneInput. Its seeds
# (tests/**/seeds/NAME/) are replayed by ctest in every build; with LARES_FUZZERS it also becomes
# a libFuzzer program.
function(lares_fuzzer NAME)
  cmake_parse_arguments(ARG "" "SOURCE;SEEDS" "DEPENDS" ${ARGN})
  add_executable(${NAME}_replay ${ARG_SOURCE} "${PROJECT_SOURCE_DIR}/tests/replay_seeds.cc")
  target_link_libraries(${NAME}_replay PRIVATE lares_flags ${ARG_DEPENDS})
  add_test(NAME ${NAME}_replay COMMAND ${NAME}_replay "${ARG_SEEDS}")
  set_tests_properties(${NAME}_replay PROPERTIES TIMEOUT 120)
  if(LARES_FUZZERS)
    add_executable(${NAME} ${ARG_SOURCE})
    target_link_libraries(${NAME} PRIVATE lares_flags ${ARG_DEPENDS})
    target_compile_options(${NAME} PRIVATE -fsanitize=fuzzer)
    target_link_options(${NAME} PRIVATE -fsanitize=fuzzer)
  endif()
endfunction()

# A folder of the house, when it has something to build.
function(lares_add_folder NAME)
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${NAME}/CMakeLists.txt")
    add_subdirectory(${NAME})
  endif()
endfunction()

# lares_plt_test(NAME PLT … FACTS …): a file of Prolog tests, run by ctest as NAME over the facts of
# N-Triples files (tests/prolog_test_runner.cc says how). Paths are relative to the calling folder.
function(lares_plt_test NAME)
  cmake_parse_arguments(ARG "" "PLT" "FACTS" ${ARGN})
  list(TRANSFORM ARG_FACTS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  add_test(NAME ${NAME}
           COMMAND prolog_test_runner "${CMAKE_CURRENT_SOURCE_DIR}/${ARG_PLT}" ${ARG_FACTS})
  # Prolog's threads do without alternative signal stacks, and it keeps its memory to the end.
  set_tests_properties(${NAME} PROPERTIES
    TIMEOUT 60 ENVIRONMENT "ASAN_OPTIONS=use_sigaltstack=0:detect_leaks=0")
endfunction()
