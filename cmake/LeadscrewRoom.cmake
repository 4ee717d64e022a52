# The house is built of rooms: folders of src/leadscrew/, each a library and a namespace of its own. What a room may include
# is what it declares, and nothing else is on its include path: every room is shown to the compiler through a folder that
# holds a link to that room alone, so that an include against the order does not compile.

set(LEADSCREW_ROOM_VIEWS ${CMAKE_BINARY_DIR}/rooms)

# What every target of the project is compiled with. Contraction is off so that the same input gives the same bits on every
# processor, with fused multiply-add or without.
function(leadscrew_compile_options TARGET)
  target_compile_features(${TARGET} PUBLIC cxx_std_20)
  set_target_properties(${TARGET} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers
    -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The compiler collects its garbage from 512 MiB on, not from 128: a twentieth less of its time.
    target_compile_options(${TARGET} PRIVATE "SHELL:--param ggc-min-heapsize=524288")
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC bug 105651: false alarms in std::string
    target_compile_options(${TARGET} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # std::stable_sort of GCC's library calls what C++17 deprecates.
    target_compile_options(${TARGET} PRIVATE -Wno-deprecated-declarations)
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    # No function is replaced by one of another library: functions of one source may be inlined in one another.
    target_compile_options(${TARGET} PRIVATE -fstack-protector-strong -D_FORTIFY_SOURCE=2 -fno-semantic-interposition)
    target_link_options(${TARGET} PRIVATE -Wl,-z,relro,-z,now)
  endif()
endfunction()

# The edge checks what it asks of the standard library in release builds too; in the core that would cost a third of the time.
function(leadscrew_checked TARGET)
  target_compile_definitions(${TARGET} PRIVATE $<$<CONFIG:Release>:_GLIBCXX_ASSERTIONS>)
endfunction()

# What libFuzzer counts: the branches of rooms, not those of tests.
function(leadscrew_fuzzed TARGET)
  if(LEADSCREW_FUZZ)
    target_compile_options(${TARGET} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# Tests are compiled without optimisation, in two thirds of the time that -O1 would take, but for those that are busy
# themselves, or with what stands in headers. KIND: test or busy_test.
function(leadscrew_test_options TARGET KIND)
  if(KIND STREQUAL "busy_test")
    set(options -O1)
  else()
    set(options -O0 -U_FORTIFY_SOURCE)  # which is for optimised code only
  endif()
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=address")
    list(APPEND options -g0)
  endif()
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(${TARGET} PRIVATE ${options})
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_link_options(${TARGET} PRIVATE -fno-lto)  # where LEADSCREW_LTO is on, the machine code of rooms as it is
  endif()
endfunction()

# Headers of the standard library and of others that most sources include, compiled once for each kind of target that they
# are compiled alike for: core (no exceptions), edge, text (edge with fmt), test. Sources include what they need all the same: the build for
# WebAssembly and the test of the include order compile without.
set(LEADSCREW_PRECOMPILED_STANDARD <algorithm> <array> <bit> <charconv> <cmath> <cstdint> <functional> <limits> <map> <memory>
  <numbers> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector> <tl/expected.hpp>)
set(LEADSCREW_PRECOMPILED_core ${LEADSCREW_PRECOMPILED_STANDARD})
set(LEADSCREW_PRECOMPILED_edge ${LEADSCREW_PRECOMPILED_STANDARD} <atomic> <chrono> <filesystem> <thread>)
set(LEADSCREW_PRECOMPILED_text ${LEADSCREW_PRECOMPILED_edge} <fmt/format.h>)
set(LEADSCREW_PRECOMPILED_busy_test ${LEADSCREW_PRECOMPILED_STANDARD} <gtest/gtest.h> <rapidcheck.h>)
set(LEADSCREW_PRECOMPILED_test ${LEADSCREW_PRECOMPILED_busy_test} <nlohmann/json.hpp>)

function(leadscrew_precompile TARGET KIND)
  if(NOT LEADSCREW_PCH OR CMAKE_CROSSCOMPILING)
    return()
  endif()
  set(first leadscrew_precompiled_${KIND})
  if(NOT TARGET ${first})
    set(source ${CMAKE_BINARY_DIR}/precompiled_${KIND}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${first} OBJECT ${source})
    leadscrew_compile_options(${first})
    if(KIND STREQUAL "core")
      target_compile_options(${first} PRIVATE -fno-exceptions)
    elseif(NOT KIND MATCHES "test$")
      leadscrew_checked(${first})
    endif()
    if(NOT KIND MATCHES "test$")
      leadscrew_fuzzed(${first})
      set_target_properties(${first} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    if(KIND STREQUAL "text")
      target_link_libraries(${first} PRIVATE fmt::fmt)
    elseif(KIND MATCHES "test$")
      target_link_libraries(${first} PRIVATE GTest::gtest rapidcheck)
      leadscrew_test_options(${first} ${KIND})
    endif()
    target_precompile_headers(${first} PRIVATE ${LEADSCREW_PRECOMPILED_${KIND}})
    if(NOT TARGET leadscrew_precompiled)
      add_custom_target(leadscrew_precompiled)  # all of them: what the linter needs of a build
    endif()
    add_dependencies(leadscrew_precompiled ${first})
  endif()
  target_precompile_headers(${TARGET} REUSE_FROM ${first})
endfunction()

# leadscrew_use(TARGET ROOM…): link these rooms and see their headers and those of the rooms that they declare; no others.
function(leadscrew_use TARGET)
  set(seen "")
  foreach(room ${ARGN})
    get_property(declared TARGET leadscrew_${room} PROPERTY LEADSCREW_DEPENDS)
    target_link_libraries(${TARGET} PRIVATE leadscrew_${room})
    list(APPEND seen ${declared} ${room})
  endforeach()
  list(REMOVE_DUPLICATES seen)
  list(TRANSFORM seen PREPEND ${LEADSCREW_ROOM_VIEWS}/)
  target_include_directories(${TARGET} PRIVATE ${seen})
endfunction()

# leadscrew_room(NAME [EDGE] [TEXT] [HOT] [COLD] [TOGETHER [APART source…]] [DEPENDS room…] [HEADERS header-only-library…]): a room of the house. EDGE rooms lie outside
# the core: they may throw, start threads and use the host's libraries. TEXT rooms, of these, write text with fmt. HOT rooms spend the
# time of planning and of words: they are compiled with -O3 (a third fewer instructions in Newton's method than with -O2).
# COLD rooms do little for each word: they are compiled with -O1, which takes a fifth less of the compiler's time.
# TOGETHER rooms have their sources compiled twelve at once but in debug builds, for what their headers cost, except for those
# APART, whose local names others have too.
function(leadscrew_room NAME)
  cmake_parse_arguments(PARSE_ARGV 1 room "EDGE;TEXT;HOT;COLD;TOGETHER" "" "APART;DEPENDS;HEADERS")
  set(target leadscrew_${NAME})
  set(view ${LEADSCREW_ROOM_VIEWS}/${NAME}/leadscrew)
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/${NAME} SYMBOLIC)

  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.hpp)
  if(NOT sources)
    # A room of headers is still a library, so that each of its headers is compiled on its own.
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
    set(text "")
    foreach(header ${headers})
      get_filename_component(file ${header} NAME)
      string(APPEND text "#include <leadscrew/${NAME}/${file}>\n")
    endforeach()
    file(CONFIGURE OUTPUT ${sources} CONTENT "${text}")
  endif()

  add_library(${target} STATIC ${sources})
  add_library(leadscrew::${NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${NAME} POSITION_INDEPENDENT_CODE ON)
  leadscrew_compile_options(${target})
  leadscrew_fuzzed(${target})
  target_include_directories(${target} PRIVATE ${LEADSCREW_ROOM_VIEWS}/${NAME}
    INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES LEADSCREW_DEPENDS "${room_DEPENDS}")
  foreach(dependency ${room_DEPENDS})
    if(NOT TARGET leadscrew_${dependency})
      message(FATAL_ERROR "room ${NAME} depends on ${dependency}, which does not stand above it")
    endif()
    target_link_libraries(${target} PUBLIC leadscrew_${dependency})
    target_include_directories(${target} PRIVATE ${LEADSCREW_ROOM_VIEWS}/${dependency})
  endforeach()
  foreach(header expected ${room_HEADERS})
    target_link_libraries(${target} PUBLIC leadscrew_header_${header})
  endforeach()
  if(room_TOGETHER AND (CMAKE_CROSSCOMPILING OR NOT CMAKE_BUILD_TYPE STREQUAL "Debug"))
    set(batch 12)
    if(room_HOT)
      set(batch 0)  # all
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
    set_source_files_properties(${room_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    # Seen together, a class of one source looks as if it stood in a header, and a local name as if it hid another source's.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-shadow -Wshadow=local)
    else()
      target_compile_options(${target} PRIVATE -Wno-shadow)
    endif()
  endif()
  if(room_HOT)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
  endif()
  if(room_COLD)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(room_EDGE)
    leadscrew_checked(${target})
  endif()
  if(NOT room_EDGE)
    target_compile_options(${target} PRIVATE -fno-exceptions)
    set_property(GLOBAL APPEND PROPERTY LEADSCREW_CORE_ROOMS ${NAME})
    leadscrew_precompile(${target} core)
  elseif(room_TEXT)
    target_link_libraries(${target} PRIVATE fmt::fmt)
    leadscrew_precompile(${target} text)
  else()
    leadscrew_precompile(${target} edge)
  endif()
  if(LEADSCREW_LTO AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Fat objects hold machine code as well: the installed archives work with any compiler.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-flto=auto;-ffat-lto-objects>)
  endif()
endfunction()

# Of LEADSCREW_LTO: the command and the benchmarks. To link takes half a minute each then, for 7 % less time of the reader.
function(leadscrew_link_time_optimisation TARGET)
  if(LEADSCREW_LTO AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-flto=auto>)
    target_link_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-flto=auto;-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
  endif()
endfunction()
