# Puts what `cmake --install` installed where Debian's policy wants it. Runs in cpack, before the packages are made.
set(staged "${CPACK_TEMPORARY_INSTALL_DIRECTORY}")
set(prefix usr)
set(doc "${staged}/tetproof/${prefix}/share/doc/tetproof")
set(doc_dev "${staged}/dev/${prefix}/share/doc/tetproof-dev")

function(compress)
  execute_process(COMMAND gzip -9 -n -f ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB programs "${staged}/tetproof/${prefix}/bin/*")
foreach(program ${programs})
  file(SIZE "${program}" bytes)
  if(bytes EQUAL 0)
    message(FATAL_ERROR "${program} is empty: was it being linked? Build first, then run cpack again")
  endif()
endforeach()

# What only a build needs is for tetproof-dev: headers, static libraries, what CMake and pkg-config look for, and the
# link by which a linker finds a shared library.
file(GLOB_RECURSE files RELATIVE "${staged}/tetproof" "${staged}/tetproof/*")
foreach(file ${files})
  if(file MATCHES "^${prefix}/include/|\\.a$|/cmake/|/pkgconfig/" OR
     (file MATCHES "^${prefix}/lib[^/]*/([^/]+/)?lib[^/]+\\.so$" AND IS_SYMLINK "${staged}/tetproof/${file}"))
    cmake_path(GET file PARENT_PATH folder)
    file(MAKE_DIRECTORY "${staged}/dev/${folder}")
    file(RENAME "${staged}/tetproof/${file}" "${staged}/dev/${file}")
  endif()
endforeach()
execute_process(COMMAND find "${staged}/tetproof" -type d -empty -delete COMMAND_ERROR_IS_FATAL ANY)

file(REMOVE "${doc}/LICENSE")   # copyright names it, and Debian has it
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)   # SOURCE_DATE_EPOCH
file(WRITE "${doc}/changelog" "tetproof (${CPACK_DEBIAN_PACKAGE_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
compress("${doc}/changelog" "${doc}/CHANGELOG.md")
file(COPY_FILE "${CPACK_TETPROOF_SOURCE}/.cmake/debian/copyright" "${doc}/copyright")
file(MAKE_DIRECTORY "${doc_dev}")
foreach(file changelog.gz copyright)
  file(COPY_FILE "${doc}/${file}" "${doc_dev}/${file}")
endforeach()

file(GLOB pages "${staged}/tetproof/${prefix}/share/man/man*/*")
if(pages)
  compress(${pages})
endif()
if(IS_DIRECTORY "${staged}/tetproof/${prefix}/share/zsh/site-functions")
  file(RENAME "${staged}/tetproof/${prefix}/share/zsh/site-functions"
    "${staged}/tetproof/${prefix}/share/zsh/vendor-completions")
endif()

# The Python module needs Python and NumPy. A compiled one is for one version of Python.
file(GLOB_RECURSE modules "${staged}/tetproof/${prefix}/lib/python3/dist-packages/*")
if(modules)
  set(CPACK_DEBIAN_TETPROOF_PACKAGE_DEPENDS "python3")
  set(CPACK_DEBIAN_TETPROOF_PACKAGE_RECOMMENDS "python3-numpy")
  if(modules MATCHES "cpython-3([0-9]+)-")
    math(EXPR next "${CMAKE_MATCH_1} + 1")
    set(CPACK_DEBIAN_TETPROOF_PACKAGE_DEPENDS "python3 (>= 3.${CMAKE_MATCH_1}~), python3 (<< 3.${next}~)")
  endif()
endif()
