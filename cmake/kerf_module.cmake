# kerf_module(NAME [DEPENDS name...] [LIBRARIES target...])
#
# One folder of src/ as one static library kerf_NAME made of the folder's .cpp files (found below it too). DEPENDS
# names the kerf folders it may include from, LIBRARIES the outside packages.
add_library(kerf_options INTERFACE)
target_compile_options(kerf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  # GCC 12 reports impossible overlaps in std::string's own operator+ (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Copies of an action (some hundred bytes) as `rep movs` take longer to start than to copy. At link time, too: the
  # release is optimised there.
  set(kerf_copies -mmemcpy-strategy=vector_loop:2048:noalign,libcall:-1:noalign)
  target_compile_options(kerf_options INTERFACE ${kerf_copies})
  target_link_options(kerf_options INTERFACE ${kerf_copies})
endif()
target_include_directories(kerf_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(KERF_SANITIZE)
  target_compile_options(kerf_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(kerf_options INTERFACE -fsanitize=address,undefined)
endif()
if(KERF_FUZZ)
  target_compile_options(kerf_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Most of a file's compile time is these headers. They are parsed once, in kerf_base, for all targets.
function(kerf_precompiled_headers target)
  if(target STREQUAL kerf_base)
    target_precompile_headers(kerf_base PRIVATE
      <algorithm> <array> <cmath> <cstdint> <fmt/format.h> <functional> <memory> <optional> <span> <string>
      <string_view> <tl/expected.hpp> <variant> <vector>)
  else()
    target_precompile_headers(${target} REUSE_FROM kerf_base)
  endif()
endfunction()

function(kerf_module name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(kerf_${name} STATIC ${sources})
    set(scope PUBLIC)
    kerf_precompiled_headers(kerf_${name})
  else()
    add_library(kerf_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(kerf_${name} ${scope} kerf_options ${ARG_LIBRARIES})
  foreach(other IN LISTS ARG_DEPENDS)
    target_link_libraries(kerf_${name} ${scope} kerf_${other})
  endforeach()
endfunction()
