# Every installed header compiles on its own, and none brings in another project's headers but Eigen's; GoogleTest's
# only <tetproof/verify/gtest.hpp> does, RapidCheck's only <tetproof/corpus/rapidcheck.hpp>, which are for that, and Boost's rational numbers the headers of the page.
# usage: cmake -DPREFIX=DIR -DCOMPILER=CXX -DEIGEN=DIR -DWORK=DIR -P check_headers.cmake
file(GLOB_RECURSE headers RELATIVE "${PREFIX}/include" "${PREFIX}/include/tetproof/*.hpp")
list(LENGTH headers count)
if(count LESS 8)
  message(FATAL_ERROR "only ${count} headers under ${PREFIX}/include/tetproof")
endif()
string(REPLACE "|" ";-isystem;" eigen "-isystem;${EIGEN}")

foreach(header ${headers})
  if(header MATCHES "/reference/paper/" AND NOT header MATCHES "/page.hpp$")
    continue()   # each begins with the one before it, so that page.hpp compiles them all in their order
  endif()
  file(WRITE "${WORK}/one_header.cpp" "#include <${header}>\n#include <${header}>\n")
  execute_process(
    COMMAND "${COMPILER}" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -MMD -MF "${WORK}/one_header.d"
      -I "${PREFIX}/include" -I "${PREFIX}/include/tetproof" ${eigen} "${WORK}/one_header.cpp"
    RESULT_VARIABLE code ERROR_VARIABLE errors)
  if(NOT code EQUAL 0)
    message(SEND_ERROR "<${header}> does not compile on its own:\n${errors}")
    continue()
  endif()
  file(READ "${WORK}/one_header.d" names)
  string(REGEX MATCHALL "[^ \\\n]*/(CGAL|openvdb|boost|fmt|tbb|oneapi|nlohmann|CLI|nanoflann|pugixml|gmsh)[^ \\\n]*" foreign "${names}")
  if(header MATCHES "/reference/paper/")
    list(FILTER foreign EXCLUDE REGEX "/boost/")
  endif()
  if(foreign)
    message(SEND_ERROR "<${header}> includes ${foreign}")
  endif()
  string(REGEX MATCH "[^ \\\n]*/(gtest|gmock)/[^ \\\n]*" googletest "${names}")
  if(googletest AND NOT header STREQUAL "tetproof/verify/gtest.hpp")
    message(SEND_ERROR "<${header}> includes ${googletest}")
  endif()
  string(REGEX MATCH "[^ \\\n]*/rapidcheck[./][^ \\\n]*" rapidcheck "${names}")
  string(REPLACE "tetproof/corpus/rapidcheck.hpp" "" rapidcheck "${rapidcheck}")
  if(rapidcheck MATCHES "rapidcheck" AND NOT header STREQUAL "tetproof/corpus/rapidcheck.hpp")
    message(SEND_ERROR "<${header}> includes ${rapidcheck}")
  endif()
endforeach()
