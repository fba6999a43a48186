// The names of the methods.

#include "lem/slices/methods.hpp"

namespace talus::lem {

const char* name_method(Method method) {
  switch (method) {
    case Method::fellenius:
      return "fellenius";
    case Method::bishop:
      return "bishop";
    case Method::janbu:
      return "janbu";
    case Method::janbu_corrected:
      return "janbu_corrected";
    case Method::spencer:
      return "spencer";
    case Method::morgenstern_price:
      return "morgenstern_price";
    case Method::morgenstern_price_constant:
      return "morgenstern_price_constant";
  }
  return "";
}

const char* title_method(Method method) {
  switch (method) {
    case Method::fellenius:
      return "Fellenius";
    case Method::bishop:
      return "Bishop simplified";
    case Method::janbu:
      return "Janbu simplified";
    case Method::janbu_corrected:
      return "Janbu corrected";
    case Method::spencer:
      return "Spencer";
    case Method::morgenstern_price:
      return "Morgenstern–Price";
    case Method::morgenstern_price_constant:
      return "Morgenstern–Price, constant function";
  }
  return "";
}

}  // namespace talus::lem
