# The installed tree holds what README promises.
# usage: cmake -DPREFIX=DIR [-DPYTHON=INTERPRETER] -P check_tree.cmake
function(expect what)   # one of the patterns matches a file
  foreach(pattern ${ARGN})
    file(GLOB found "${PREFIX}/${pattern}")
    if(found)
      return()
    endif()
  endforeach()
  message(SEND_ERROR "${what} is not installed: nothing at ${ARGN} under ${PREFIX}")
endfunction()

foreach(program tetproof-mesh tetproof-verify tetproof-compare tetproof-convert)
  expect("the program ${program}" bin/${program})
endforeach()
expect("the program that reads through Gmsh" libexec/tetproof/tetproof-gmsh-import)
foreach(folder io reference verify corpus)
  expect("the library ${folder}" lib/libtetproof_${folder}.a lib/*/libtetproof_${folder}.a)
  expect("a header of ${folder}" include/tetproof/${folder}/*.hpp)
endforeach()
foreach(file tetproofConfig.cmake tetproofConfigVersion.cmake tetproofTargets.cmake)
  expect("${file}" lib/cmake/tetproof/${file} lib/*/cmake/tetproof/${file})
endforeach()
expect("the schema of --json" share/tetproof/report.schema.json)
if(PYTHON)   # the Python package was built for this Python: it is where that looks below a prefix, and works there
  file(GLOB package "${PREFIX}/lib/python3*/dist-packages")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${package}" "${PYTHON}" -c
    "import tetproof; p = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]; print(tetproof.__file__, tetproof.verify(p, [[0, 1, 2, 3]]).verdict)"
    OUTPUT_VARIABLE said RESULT_VARIABLE code)
  if(code OR NOT said MATCHES "^${package}/tetproof/__init__.py sound")
    message(SEND_ERROR "the installed Python package does not work: ${said}")
  endif()
  expect("a type stub of the Python package" lib/python3*/dist-packages/tetproof/_core.pyi)
endif()
foreach(document README.md CHANGELOG.md LICENSE)
  expect("${document}" share/doc/tetproof/${document})
endforeach()
