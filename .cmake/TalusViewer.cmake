# The built viewer as talusd serves it: its files, and FILE.gz and FILE.br beside those that compress. Target talus_viewer;
# web/ in the build folder, share/talus/web once installed. Without client_sample/web/viewer/dist there is nothing to do.
set(talus_viewer_dist ${PROJECT_SOURCE_DIR}/client_sample/web/viewer/dist)
set(talus_viewer ${PROJECT_BINARY_DIR}/web)
find_program(TALUS_GZIP gzip)
find_program(TALUS_BROTLI brotli)

file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${talus_viewer_dist} ${talus_viewer_dist}/*)
set(made "")
foreach(file IN LISTS files)
  set(outputs ${talus_viewer}/${file})
  get_filename_component(folder ${talus_viewer}/${file} DIRECTORY)
  set(commands COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${CMAKE_COMMAND} -E copy ${talus_viewer_dist}/${file} ${talus_viewer}/${file})
  if(file MATCHES "\\.(html|js|mjs|css|json|svg|wasm|map|txt|webmanifest)$")
    if(TALUS_GZIP)  # without name and time: the same bytes each time
      list(APPEND outputs ${talus_viewer}/${file}.gz)
      list(APPEND commands COMMAND ${TALUS_GZIP} --best --no-name --force --keep ${talus_viewer}/${file})
    endif()
    if(TALUS_BROTLI)
      list(APPEND outputs ${talus_viewer}/${file}.br)
      list(APPEND commands COMMAND ${TALUS_BROTLI} --best --force --keep ${talus_viewer}/${file})
    endif()
  endif()
  add_custom_command(OUTPUT ${outputs} ${commands} DEPENDS ${talus_viewer_dist}/${file} COMMENT "Compressing ${file}" VERBATIM)
  list(APPEND made ${outputs})
endforeach()

# What an earlier build of the viewer left there would be served too.
file(GLOB_RECURSE there ${talus_viewer}/*)
foreach(file IN LISTS there)
  if(NOT file IN_LIST made)
    file(REMOVE ${file})
  endif()
endforeach()

add_custom_target(talus_viewer ALL DEPENDS ${made})
if(made)
  install(DIRECTORY ${talus_viewer}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/talus/web COMPONENT server)
endif()
