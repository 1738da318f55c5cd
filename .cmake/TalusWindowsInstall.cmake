# The component "windows" of the zip (package_windows in .dev/windows.sh): programs, worlds, and what the licences ask for of the
# libraries inside, as Debian's packages say it. libtalus is the component c_api.
install(TARGETS talus-client talus-gen RUNTIME COMPONENT windows)
install(DIRECTORY core/worlds DESTINATION . COMPONENT windows)
install(FILES LICENSE DESTINATION . COMPONENT windows)
# Beside share/talus/bindings, where they look for them.
install(DIRECTORY client_sample/c_api/examples/ DESTINATION share/talus/examples COMPONENT windows)
foreach(package gcc-mingw-w64-x86-64-posix libasio-dev libcli11-dev libexpected-dev libflatbuffers-dev libglm-dev libhwy-dev
    libpng-dev libssl-dev libtomlplusplus-dev libxxhash-dev libz-mingw-w64-dev libzstd-dev mingw-w64-x86-64-dev
    nlohmann-json3-dev)
  install(FILES /usr/share/doc/${package}/copyright DESTINATION licences RENAME ${package}.txt COMPONENT windows)
endforeach()
