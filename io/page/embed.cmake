# Puts files into the library, with their hashes: embed(NAME FILE) makes io::NAME of FILE. The file is read when the
# library is configured and built, so that text and hash are always of the same file.
function(embed target name file)
  file(SHA256 "${file}" sha256)
  file(SIZE "${file}" size)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/resource.cpp.in" "${source}" @ONLY)
  set_source_files_properties("${source}" PROPERTIES OBJECT_DEPENDS "${file}" SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE "${source}")
endfunction()
