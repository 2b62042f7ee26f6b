# Helpers every folder's CMakeLists uses: one way to declare a library, one way to embed files.

set(FENESTRA_CMAKE_FOLDER "${CMAKE_CURRENT_LIST_DIR}")
set(FENESTRA_PRECOMPILED "${FENESTRA_CMAKE_FOLDER}/precompiled")
if(FENESTRA_ASSERTIONS)
  add_compile_options(-UNDEBUG)  # after the -DNDEBUG of Release
endif()
if(FENESTRA_UNITY)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects its garbage from 512 MB on, not from 128: a batch takes at most 0.3 GB more and some 7 % less time.
  add_compile_options("SHELL:--param ggc-min-heapsize=524288")
endif()
find_program(FENESTRA_MOLD mold)
if(FENESTRA_MOLD AND NOT FENESTRA_SANITIZE AND NOT FENESTRA_FUZZ)
  add_link_options(-fuse-ld=mold)  # a program of ours in a tenth of the time that GNU ld takes
endif()

# fenestra_precompile(TARGET HEADER|TARGET_WITH_IT): headers of FENESTRA_PRECOMPILED, or those of a target of the same
# flags, are read once instead of once a file.
function(fenestra_precompile TARGET HEADERS)
  if(NOT FENESTRA_PRECOMPILE)
    return()
  endif()
  if(TARGET ${HEADERS})
    target_precompile_headers(${TARGET} REUSE_FROM ${HEADERS})
  else()
    target_precompile_headers(${TARGET} PRIVATE "${FENESTRA_PRECOMPILED}/${HEADERS}")
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # ccache needs the first. GCC 12 loses places in precompiled headers, and then reports false array bounds.
    target_compile_options(${TARGET} PRIVATE -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow
                           -Wno-stringop-overread)
  endif()
endfunction()

# fenestra_precompiled(TARGET HEADER [libs...]): an empty library that holds precompiled headers for others to reuse.
function(fenestra_precompiled TARGET HEADER)
  if(NOT FENESTRA_PRECOMPILE)
    return()
  endif()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp" CONTENT "")
  add_library(${TARGET} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp")
  target_include_directories(${TARGET} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_compile_definitions(${TARGET} PRIVATE ${FENESTRA_GLM_DEFINITIONS})
  target_link_libraries(${TARGET} PRIVATE ${ARGN})
  fenestra_own_code(${TARGET})
  fenestra_precompile(${TARGET} ${HEADER})
endfunction()

# fenestra_library(NAME SOURCES... [PUBLIC libs...] [PRIVATE libs...] [PRECOMPILED header] [FOR_MODULES] [LIGHT])
# A static library `fenestra_NAME`, alias `fenestra::NAME`, with the project's warnings as errors and the repository root
# as its only include directory. PRECOMPILED: in place of Standard.h. FOR_MODULES: modules link it, too. LIGHT: as
# fenestra_light_code has it.
function(fenestra_library NAME)
  cmake_parse_arguments(ARG "FOR_MODULES;LIGHT" "PRECOMPILED" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target fenestra_${NAME})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fenestra::${NAME} ALIAS ${target})
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  fenestra_own_code(${target})
  if(ARG_LIGHT)
    fenestra_light_code(${target})
  endif()
  if(ARG_FOR_MODULES)
    fenestra_for_modules(${target})
    fenestra_precompile(${target} fenestra_modules_standard)
  elseif(ARG_PRECOMPILED)
    fenestra_precompile(${target} ${ARG_PRECOMPILED})
  else()
    fenestra_precompile(${target} fenestra_standard)
  endif()
endfunction()

# Code without loops over voxels or pixels. Inlining and vectorising gain nothing there, and take a third of the time to
# compile it.
function(fenestra_light_code TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Code that modules link, too.
function(fenestra_for_modules TARGET)
  set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # No other module replaces our functions at load time, so calls among them are as fast as in a program.
  target_compile_options(${TARGET} PRIVATE -fno-semantic-interposition)
endfunction()

# The project's own code: warnings are errors, sanitizers when asked for.
function(fenestra_own_code TARGET)
  target_compile_features(${TARGET} PUBLIC cxx_std_20)
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Werror)
  if(FENESTRA_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Types of an anonymous namespace are local to the batch, although their file is included.
    target_compile_options(${TARGET} PRIVATE -Wno-subobject-linkage)
  endif()
  if(FENESTRA_SANITIZE)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # With sanitizers GCC 12 reports initialised parts of std::regex and std::optional as uninitialised (GCC bug 105562).
      target_compile_options(${TARGET} PRIVATE -Wno-maybe-uninitialized)
    endif()
    target_compile_options(${TARGET} PUBLIC -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${TARGET} PUBLIC -fsanitize=address,undefined)
  endif()
  if(FENESTRA_FUZZ)
    target_compile_options(${TARGET} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# fenestra_embed(NAME ROOT dir FILES rel/paths...)
# A library `fenestra::NAME` that holds the files' bytes: `std::string_view fenestra::NAME::find(std::string_view path)`
# (empty when absent) and `fenestra::NAME::paths()`. Declared in the generated header "fenestra/NAME.h".
function(fenestra_embed NAME)
  cmake_parse_arguments(ARG "" "ROOT" "FILES" ${ARGN})
  set(out "${CMAKE_CURRENT_BINARY_DIR}/${NAME}")
  set(inputs ${ARG_FILES})
  list(TRANSFORM inputs PREPEND "${ARG_ROOT}/")
  string(REPLACE ";" "|" packed "${ARG_FILES}")
  add_custom_command(
    OUTPUT "${out}/fenestra/${NAME}.h" "${out}/${NAME}.cpp"
    COMMAND ${CMAKE_COMMAND} -DNAME=${NAME} -DROOT=${ARG_ROOT} -DOUT=${out} "-DFILES=${packed}"
            -P "${PROJECT_SOURCE_DIR}/packaging/cmake/Embed.cmake"
    DEPENDS ${inputs} "${PROJECT_SOURCE_DIR}/packaging/cmake/Embed.cmake"
    VERBATIM)
  add_library(fenestra_${NAME} STATIC "${out}/${NAME}.cpp" "${out}/fenestra/${NAME}.h")
  add_library(fenestra::${NAME} ALIAS fenestra_${NAME})
  target_include_directories(fenestra_${NAME} PUBLIC "${out}")
  target_compile_features(fenestra_${NAME} PUBLIC cxx_std_20)
endfunction()

# fenestra_test_program(NAME SOURCES... LIBS libs... [PRECOMPILED header] [UNOPTIMISED])
# An executable of tests. Optimised less than the libraries that it tests, because its own code runs briefly.
# UNOPTIMISED: not at all, which compiles in two thirds of the time; it computes nothing itself, and has a precompiled
# header of its own.
function(fenestra_test_program NAME)
  cmake_parse_arguments(ARG "UNOPTIMISED" "PRECOMPILED" "SOURCES;LIBS" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBS} fenestra_test_support)
  fenestra_own_code(${NAME})
  if(ARG_UNOPTIMISED)
    target_compile_options(${NAME} PRIVATE $<$<CONFIG:Release>:-O0>)
  else()
    fenestra_light_code(${NAME})
  endif()
  if(FENESTRA_UNITY)
    # Constants of one test file are no concern of the next.
    target_compile_options(${NAME} PRIVATE -Wno-shadow)
  endif()
  if(ARG_PRECOMPILED)
    fenestra_precompile(${NAME} ${ARG_PRECOMPILED})
  else()
    fenestra_precompile(${NAME} fenestra_tests_standard)
  endif()
endfunction()

# fenestra_test(NAME SOURCES... LIBS libs... [PRECOMPILED header] [UNOPTIMISED] [LABEL label] [FIRST suites...]
#               [ENVIRONMENT variables...])
# A GoogleTest executable whose suites ctest lists one by one; the cases of a suite share a process, and so an OpenGL
# context. Those whose names begin with Thorough_ or Exhaustive_ are a test of their own, with the label `thorough` or
# `exhaustive`, which `packaging/test` runs where it is asked to. ctest starts the suites of FIRST before all others, in
# that order: those that take longest, so that no processor waits for one of them at the end.
function(fenestra_test NAME)
  cmake_parse_arguments(ARG "UNOPTIMISED" "PRECOMPILED;LABEL" "SOURCES;LIBS;FIRST;ENVIRONMENT" ${ARGN})
  set(unoptimised)
  if(ARG_UNOPTIMISED)
    set(unoptimised UNOPTIMISED)
  endif()
  fenestra_test_program(${NAME} SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS} PRECOMPILED ${ARG_PRECOMPILED} ${unoptimised})
  fenestra_suites(${NAME} LABELS ${ARG_LABEL} FIRST ${ARG_FIRST} ENVIRONMENT ${ARG_ENVIRONMENT})
endfunction()

# fenestra_suites(NAME [PREFIX prefix] [LABELS labels...] [ONLY suites...] [EXCEPT suites...] [FIRST suites...]
#                 [ENVIRONMENT variables...])
# One ctest test a suite of an executable, found by running it after each link: PREFIX + SUITE, for all suites or ONLY
# those named. Answers and compiled shaders are kept in the build folder, not in the user's home.
function(fenestra_suites NAME)
  cmake_parse_arguments(ARG "" "PREFIX" "LABELS;ONLY;EXCEPT;FIRST;ENVIRONMENT" ${ARGN})
  set(list "${CMAKE_CURRENT_BINARY_DIR}/${ARG_PREFIX}${NAME}_suites.cmake")
  set(parameters "-DPROGRAM=$<TARGET_FILE:${NAME}>" "-DLIST=${list}" "-DPREFIX=${ARG_PREFIX}")
  foreach(part LABELS ONLY EXCEPT FIRST)
    list(JOIN ARG_${part} ":" joined)
    list(APPEND parameters "-D${part}=${joined}")
  endforeach()
  list(JOIN ARG_ENVIRONMENT "|" joined)
  list(APPEND parameters "-DENVIRONMENT=${joined}|XDG_CACHE_HOME=${PROJECT_BINARY_DIR}/cache")
  add_custom_command(TARGET ${NAME} POST_BUILD
    COMMAND ${CMAKE_COMMAND} ${parameters} -P "${FENESTRA_CMAKE_FOLDER}/Suites.cmake"
    BYPRODUCTS "${list}" VERBATIM)
  # The tests of a program that is not built fail; they are not passed over.
  file(CONFIGURE OUTPUT "${list}.in" @ONLY CONTENT [[
if(EXISTS "@list@")
  include("@list@")
else()
  add_test("@ARG_PREFIX@@NAME@_is_not_built" "@NAME@ is not built")
endif()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list}.in")
endfunction()
