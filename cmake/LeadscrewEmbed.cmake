# leadscrew_embed(TARGET ROOM FILE…): text files as strings of the program. page.css is then
# `extern const std::string_view page_css` in the room's namespace, byte by byte; the room's headers declare it.
function(leadscrew_embed TARGET ROOM)
  foreach(path ${ARGN})
    cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE file)
    cmake_path(GET file FILENAME name)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    string(MAKE_C_IDENTIFIER ${name} identifier)
    file(READ ${file} text)
    if(text MATCHES "\\)embedded\"")
      message(FATAL_ERROR "${file} holds the mark that ends it")
    endif()
    # Neither configured nor generated: what looks like a variable or a generator expression is the text's own.
    string(CONCAT source "#include <string_view>\n\nnamespace leadscrew::${ROOM} {\n"
      "extern const std::string_view ${identifier};\n"
      "constinit const std::string_view ${identifier} = R\"embedded(${text})embedded\";\n"
      "}  // namespace leadscrew::${ROOM}\n")
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    set(known "")
    if(EXISTS ${output})
      file(READ ${output} known)
    endif()
    if(NOT known STREQUAL source)
      file(WRITE ${output} "${source}")
    endif()
    target_sources(${TARGET} PRIVATE ${output})
  endforeach()
endfunction()
