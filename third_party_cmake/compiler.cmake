# One place for what every target is compiled with.
# RelWithAsserts is -O2 with assertions: what the tests run in.
# (No cache entries: project() has already made empty ones, which would win.)
set(CMAKE_CXX_FLAGS_RELWITHASSERTS -O2)
set(CMAKE_C_FLAGS_RELWITHASSERTS -O2)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  # The precompiled header's macros and times are accepted: its content is hashed all the same.
  set(TORRANCE_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TORRANCE_LAUNCHER})
  set(CMAKE_C_COMPILER_LAUNCHER ${TORRANCE_LAUNCHER})
endif()

# -ffp-contract=off: a fused multiply-add changes the last bit from one processor to the next, and the same inputs give the same bytes.
add_library(torrance_compiler INTERFACE)
target_compile_options(torrance_compiler INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
target_include_directories(torrance_compiler INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR})
if(TORRANCE_SANITIZE)
  target_compile_options(torrance_compiler INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1)
  target_link_options(torrance_compiler INTERFACE -fsanitize=address,undefined)
endif()

# A folder of src/ is one static library: torrance_library(NAME [EXCLUDE files...] DEPENDS folders... LIBRARIES packages...)
# DEPENDS is checked against the table in src/README.md by tools/check_layers.py.
function(torrance_library NAME)
  cmake_parse_arguments(ARG "" "" "EXCLUDE;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.cpp)
  if(ARG_EXCLUDE)
    list(REMOVE_ITEM SOURCES ${ARG_EXCLUDE})
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND torrance_)
  if(NOT SOURCES)
    add_library(torrance_${NAME} INTERFACE)
    target_link_libraries(torrance_${NAME} INTERFACE torrance_compiler ${ARG_DEPENDS} ${ARG_LIBRARIES} ${ARG_PRIVATE_LIBRARIES})
    return()
  endif()
  add_library(torrance_${NAME} STATIC ${SOURCES})
  target_link_libraries(torrance_${NAME} PUBLIC torrance_compiler ${ARG_DEPENDS} ${ARG_LIBRARIES} PRIVATE ${ARG_PRIVATE_LIBRARIES})
endfunction()
