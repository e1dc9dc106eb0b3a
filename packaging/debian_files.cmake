# Run by CPack over the files of each package before it is made: what Debian wants otherwise than
# other systems. Man pages and changelogs are compressed, without the time, so that they are the same
# bytes each time; Debian's own changelog names the release.
file(GLOB roots LIST_DIRECTORIES true "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr")
foreach(root IN LISTS roots)
    set(doc ${root}/share/doc/vybeg)
    file(READ ${root}/share/metainfo/io.github.vybeg.Vybeg.metainfo.xml metainfo)
    string(REGEX MATCH "<release [^>]*date=\"([-0-9]+)\"" release "${metainfo}")
    execute_process(COMMAND date --utc --rfc-email --date=${CMAKE_MATCH_1}
        OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    file(WRITE ${doc}/changelog.Debian
"vybeg (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; what is new stands in changelog.gz.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
    file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
    file(GLOB_RECURSE pages ${root}/share/man/*)
    execute_process(COMMAND gzip --best --no-name ${doc}/changelog ${doc}/changelog.Debian ${pages}
        COMMAND_ERROR_IS_FATAL ANY)
endforeach()
