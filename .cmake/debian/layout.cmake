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

# A shared library: how packages that link it depend on it, and the trigger by which the loader finds it.
file(GLOB shared RELATIVE "${staged}/tetproof/${prefix}/lib" "${staged}/tetproof/${prefix}/lib/lib*.so.*"
  "${staged}/tetproof/${prefix}/lib/*/lib*.so.*")
list(FILTER shared INCLUDE REGEX "\\.so\\.[0-9]+$")
set(remarks "")
set(remarks_dev "")
if(shared)
  set(control "${staged}/../control")
  file(WRITE "${control}/triggers" "activate-noawait ldconfig\n")
  file(WRITE "${control}/shlibs" "")
  foreach(library ${shared})
    string(REGEX REPLACE "^(.*/)?(lib[^/]+)\\.so\\.([0-9]+)$" "\\2 \\3" library "${library}")
    file(APPEND "${control}/shlibs" "${library} tetproof (= ${CPACK_DEBIAN_PACKAGE_VERSION})\n")
  endforeach()
  set(CPACK_DEBIAN_TETPROOF_PACKAGE_CONTROL_EXTRA "${control}/triggers" "${control}/shlibs")
  string(APPEND remarks "# The library is for programs that users build, beside the programs; no other package links it.
tetproof: package-name-doesnt-match-sonames *
# CPack writes these scripts itself, beside the trigger.
tetproof: maintscript-calls-ldconfig *
")
endif()
if(IS_DIRECTORY "${staged}/dev/${prefix}/lib/pkgconfig")
  string(APPEND remarks_dev "# The package is for the machine that it was built on, and its files find each other wherever the tree is.
tetproof-dev: pkg-config-unavailable-for-cross-compilation *
")
endif()
if(remarks)
  file(WRITE "${staged}/tetproof/${prefix}/share/lintian/overrides/tetproof" "${remarks}")
endif()
if(remarks_dev)
  file(WRITE "${staged}/dev/${prefix}/share/lintian/overrides/tetproof-dev" "${remarks_dev}")
endif()

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

# Below /usr/local, which the build may have been made for, the folder of Python's modules has a version. Below /usr it has none.
file(GLOB versioned "${staged}/tetproof/${prefix}/lib/python3.*/dist-packages")
if(versioned)
  file(MAKE_DIRECTORY "${staged}/tetproof/${prefix}/lib/python3")
  file(RENAME "${versioned}" "${staged}/tetproof/${prefix}/lib/python3/dist-packages")
  cmake_path(GET versioned PARENT_PATH versioned)
  file(REMOVE_RECURSE "${versioned}")
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
  # Python writes bytecode beside a module that root imports: it goes with the package.
  file(WRITE "${staged}/../control/prerm" "#!/bin/sh\nset -e\nif command -v py3clean >/dev/null 2>&1; then py3clean -p tetproof; fi\n")
  list(APPEND CPACK_DEBIAN_TETPROOF_PACKAGE_CONTROL_EXTRA "${staged}/../control/prerm")
endif()

# The libraries that programs and modules are linked with, by the packages that have them. A helper in libexec is a
# process of its own: what only it needs is recommended, because the programs do without it, and say so.
set(with_libraries "")
set(helpers "")
file(GLOB_RECURSE files "${staged}/tetproof/*")
foreach(file ${files})
  file(READ "${file}" magic LIMIT 4 HEX)
  if(magic STREQUAL "7f454c46" AND NOT IS_SYMLINK "${file}")
    if(file MATCHES "/libexec/")
      list(APPEND helpers "${file}")
    else()
      list(APPEND with_libraries "${file}")
    endif()
  endif()
endforeach()
if(with_libraries OR helpers)
  file(WRITE "${staged}/../control/debian/control" "")   # dpkg-shlibdeps wants one
  execute_process(COMMAND dpkg-shlibdeps --ignore-missing-info -O -dDepends ${with_libraries} -dRecommends ${helpers}
    WORKING_DIRECTORY "${staged}/../control" OUTPUT_VARIABLE found ERROR_VARIABLE said RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "dpkg-shlibdeps: ${said}")
  endif()
  foreach(field Depends Recommends)
    if(found MATCHES "shlibs:${field}=([^\n]*)")
      string(TOUPPER "CPACK_DEBIAN_TETPROOF_PACKAGE_${field}" all)
      list(APPEND ${all} "${CMAKE_MATCH_1}")
      string(JOIN ", " ${all} ${${all}})
    endif()
  endforeach()
endif()
