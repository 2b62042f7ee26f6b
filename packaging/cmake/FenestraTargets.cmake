# Helpers every folder's CMakeLists uses: one way to declare a library, one way to embed files.

# fenestra_library(NAME SOURCES... [PUBLIC libs...] [PRIVATE libs...] [FOR_MODULES])
# A static library `fenestra_NAME`, alias `fenestra::NAME`, with the project's warnings as errors and the repository root
# as its only include directory. FOR_MODULES: modules link it, too.
function(fenestra_library NAME)
  cmake_parse_arguments(ARG "FOR_MODULES" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target fenestra_${NAME})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fenestra::${NAME} ALIAS ${target})
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  fenestra_own_code(${target})
  if(ARG_FOR_MODULES)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    # Nobody replaces our functions: calls among them stay as fast as in a program.
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()

# The project's own code: warnings are errors, sanitizers when asked for.
function(fenestra_own_code TARGET)
  target_compile_features(${TARGET} PUBLIC cxx_std_20)
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Werror)
  if(FENESTRA_SANITIZE)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # With sanitizers GCC 12 calls parts of std::regex and std::optional uninitialised that are not (GCC bug 105562).
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

# fenestra_test(NAME SOURCES... LIBS libs... [LABEL label] [EXHAUSTIVE cases...])
# A GoogleTest executable whose cases ctest lists one by one. The cases of EXHAUSTIVE, in the words of GoogleTest's filter,
# have the label `exhaustive` and ten minutes in place of two: `packaging/test` runs them only where it is asked for all.
function(fenestra_test NAME)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;LIBS;EXHAUSTIVE" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBS} fenestra_test_support)
  fenestra_own_code(${NAME})
  set(filter)
  if(ARG_EXHAUSTIVE)
    list(JOIN ARG_EXHAUSTIVE ":" exhaustive)
    fenestra_discover(${NAME} ${NAME}_exhaustive "${exhaustive}" 600 exhaustive)
    set(filter "-${exhaustive}")
  endif()
  fenestra_discover(${NAME} ${NAME}_cases "${filter}" 120 ${ARG_LABEL})
endfunction()

# fenestra_discover(NAME LIST FILTER TIMEOUT [LABEL]): the cases of an executable that the filter lets pass.
function(fenestra_discover NAME LIST FILTER TIMEOUT)
  # Answers and compiled shaders are kept in the build folder, not in the user's home.
  set(properties TIMEOUT ${TIMEOUT} ENVIRONMENT "XDG_CACHE_HOME=${PROJECT_BINARY_DIR}/cache")
  if(ARGN)
    list(APPEND properties LABELS ${ARGN})
  endif()
  gtest_discover_tests(${NAME} TEST_FILTER "${FILTER}" TEST_LIST ${LIST} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
