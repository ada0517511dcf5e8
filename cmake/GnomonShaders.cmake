# SPDX-License-Identifier: MIT
# Shaders as part of a build. Documented in docs/building-with-gnomon.md.
#
#   gnomon_add_shaders(TARGET <t> SOURCES <file>... TARGETS <target>...
#                      [DEFINES <NAME[=VALUE]>...] [INCLUDE_DIRECTORIES <dir>...] [EMBED <target>...]
#                      [OUTPUT_DIRECTORY <dir>] [NAME <name>] [STAGE <vert|frag|geom|comp>])
#
# Compiles every source for every target with gnomonc while <t> is built, again whenever the source, a file that it
# includes, an option or gnomonc changes. The outputs are <dir>/<file name>.<suffix>, by default in
# ${CMAKE_CURRENT_BINARY_DIR}/<t>_shaders; the property GNOMON_SHADERS of <t> lists them with their paths. With the
# target `header` the folder is an include directory of <t>, and NAME, for a single source, the name of its namespace:
# two shaders whose files are called alike need it. STAGE is for sources whose extension does not tell it.
cmake_minimum_required(VERSION 3.25)

function(gnomon_suffix_of target result)
  set(suffixes
      "glsl450:glsl450.glsl" "glsl330:glsl330.glsl" "essl300:essl300.glsl" "essl310:essl310.glsl" "vulkan:vulkan.spv"
      "opengl:opengl.spv" "hlsl50:hlsl50.hlsl" "msl21:msl21.metal" "header:h")
  foreach(pair IN LISTS suffixes)
    if(pair MATCHES "^${target}:(.*)$")
      set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  string(REGEX REPLACE ":[^;]*" "" known "${suffixes}")
  list(JOIN known ", " known)
  message(FATAL_ERROR "gnomon_add_shaders: unknown target \"${target}\": known are ${known}")
endfunction()

# One source for one target; `options` are those of gnomonc.
function(gnomon_add_shader source target output options)
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "$<TARGET_FILE:gnomon::gnomonc>" build "${source}" --target "${target}" ${options} -o "${output}" -MD
    DEPENDS "${source}" "$<TARGET_FILE:gnomon::gnomonc>"
    DEPFILE "${output}.d"
    COMMENT "Compiling shader ${output}"
    VERBATIM)
  set_source_files_properties("${output}" PROPERTIES HEADER_FILE_ONLY TRUE)
endfunction()

function(gnomon_add_shaders)
  set(lists SOURCES TARGETS DEFINES INCLUDE_DIRECTORIES EMBED)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;OUTPUT_DIRECTORY;NAME;STAGE" "${lists}")
  foreach(name TARGET SOURCES TARGETS)
    if(NOT arg_${name})
      message(FATAL_ERROR "gnomon_add_shaders: ${name} is missing")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gnomon_add_shaders: what is \"${arg_UNPARSED_ARGUMENTS}\"? Expected TARGET, SOURCES, "
                        "TARGETS, DEFINES, INCLUDE_DIRECTORIES, EMBED, OUTPUT_DIRECTORY, NAME or STAGE before it")
  endif()
  if(NOT TARGET "${arg_TARGET}")
    message(FATAL_ERROR "gnomon_add_shaders: there is no target \"${arg_TARGET}\": add it before its shaders")
  endif()
  # CMake builds the outputs of a custom command only for targets of the same folder.
  get_target_property(target_directory "${arg_TARGET}" SOURCE_DIR)
  if(NOT target_directory STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    message(FATAL_ERROR "gnomon_add_shaders: the target \"${arg_TARGET}\" belongs to ${target_directory}: add its shaders "
                        "in the CMakeLists.txt there, after the target")
  endif()
  if(NOT TARGET gnomon::gnomonc)
    message(FATAL_ERROR "gnomon_add_shaders: the program gnomonc is not installed beside this CMake package: install "
                        "gnomon's component `tools` too")
  endif()

  list(LENGTH arg_SOURCES number_of_sources)
  if(arg_NAME AND number_of_sources GREATER 1)
    message(FATAL_ERROR "gnomon_add_shaders: NAME is for one source: call gnomon_add_shaders for each of them")
  endif()

  if(NOT arg_OUTPUT_DIRECTORY)
    set(arg_OUTPUT_DIRECTORY "${arg_TARGET}_shaders")
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT_DIRECTORY BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE)
  file(MAKE_DIRECTORY "${arg_OUTPUT_DIRECTORY}")
  set(options)
  # The form that Visual Studio finds files in.
  if(CMAKE_GENERATOR MATCHES "Visual Studio")
    list(APPEND options --errfmt msvc)
  endif()
  if(arg_STAGE)
    if(NOT arg_STAGE MATCHES "^(vert|frag|geom|comp)$")
      message(FATAL_ERROR "gnomon_add_shaders: unknown STAGE \"${arg_STAGE}\": known are vert, frag, geom, comp")
    endif()
    list(APPEND options --stage "${arg_STAGE}")
  endif()
  foreach(define IN LISTS arg_DEFINES)
    list(APPEND options -D "${define}")
  endforeach()
  foreach(directory IN LISTS arg_INCLUDE_DIRECTORIES)
    cmake_path(ABSOLUTE_PATH directory NORMALIZE)
    list(APPEND options -I "${directory}")
  endforeach()

  get_target_property(known "${arg_TARGET}" GNOMON_SHADERS)
  if(NOT known)
    set(known)
  endif()
  set(outputs)
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    cmake_path(GET source FILENAME name)
    foreach(target IN LISTS arg_TARGETS)
      gnomon_suffix_of("${target}" suffix)
      set(output "${arg_OUTPUT_DIRECTORY}/${name}.${suffix}")
      if(output IN_LIST outputs OR output IN_LIST known)
        message(FATAL_ERROR "gnomon_add_shaders: two sources would be written to \"${output}\": rename one, or call "
                            "gnomon_add_shaders again for it with another OUTPUT_DIRECTORY and, for headers, a NAME")
      endif()
      set(own_options ${options})
      if(target STREQUAL "header")
        foreach(embedded IN LISTS arg_EMBED)
          list(APPEND own_options --embed "${embedded}")
        endforeach()
        if(arg_NAME)
          list(APPEND own_options --name "${arg_NAME}")
        endif()
      endif()
      gnomon_add_shader("${source}" "${target}" "${output}" "${own_options}")
      list(APPEND outputs "${output}")
    endforeach()
  endforeach()
  target_sources("${arg_TARGET}" PRIVATE ${outputs})
  set_property(TARGET "${arg_TARGET}" APPEND PROPERTY GNOMON_SHADERS ${outputs})
  get_target_property(type "${arg_TARGET}" TYPE)
  if("header" IN_LIST arg_TARGETS AND NOT type STREQUAL "UTILITY")
    target_include_directories("${arg_TARGET}" PRIVATE "${arg_OUTPUT_DIRECTORY}")
  endif()
endfunction()
