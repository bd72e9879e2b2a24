# The dictionary files of WordNet 3.0, as Debian's wordnet-base has them. Defines WordNet_DICT, the
# folder with data.noun; set it to use another copy.
find_path(WordNet_DICT data.noun
          PATHS /usr/share/wordnet /usr/local/share/wordnet /usr/share/wordnet/dict
                /usr/local/WordNet-3.0/dict /opt/homebrew/opt/wordnet/dict
          NO_DEFAULT_PATH)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  WordNet REQUIRED_VARS WordNet_DICT
  REASON_FAILURE_MESSAGE "install Debian's wordnet-base, or set WordNet_DICT to the folder with data.noun")
mark_as_advanced(WordNet_DICT)
