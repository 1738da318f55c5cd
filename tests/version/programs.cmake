# The commit is of the last build, which may be older than HEAD, and unknown in an archive without it.
foreach(program IN LISTS PROGRAMS)
  get_filename_component(name ${program} NAME)
  execute_process(COMMAND ${program} --version OUTPUT_VARIABLE printed RESULT_VARIABLE status)
  string(REPLACE "." "[.]" version ${VERSION})
  if(NOT status EQUAL 0 OR NOT printed MATCHES "^${name} ${version}( [(][0-9a-f]+[)])?( |\n)")
    message(SEND_ERROR "${name} --version ended with ${status} and printed '${printed}'")
  endif()
endforeach()
