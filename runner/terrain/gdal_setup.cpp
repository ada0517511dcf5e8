// SPDX-License-Identifier: MIT
#include "terrain/gdal_setup.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <mutex>
#include <utility>

namespace gnomon::terrain {
namespace {

void CPL_STDCALL on_message(CPLErr severity, CPLErrorNum, const char* message) {
  if (severity == CE_Failure || severity == CE_Fatal)
    static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->hear(message);
}

void set_up() {
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
  CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");
  CPLSetConfigOption("GDAL_GEOREF_SOURCES", "INTERNAL");  // no .tfw
  CPLSetConfigOption("GTIFF_REPORT_COMPD_CS", "YES");     // else the unit of the heights is lost
  CPLSetConfigOption("AAIGRID_DATATYPE", "Float64");      // else heights round before they are scaled
  OSRSetPROJEnableNetwork(false);
  // Not GDALAllRegister(): it loads every plugin, and formats that read other files or the network.
  GDALRegister_GTiff();
  GDALRegister_SRTMHGT();
  GDALRegister_AAIGrid();
  GDALRegister_USGSDEM();
}

}  // namespace

void set_up_gdal() {
  static std::once_flag once;
  std::call_once(once, set_up);
}

GdalMessages::GdalMessages() {
  CPLPushErrorHandlerEx(on_message, this);
}

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
}

std::string GdalMessages::take() {
  return std::exchange(first_, {}).substr(0, first_.find('\n'));
}

}  // namespace gnomon::terrain
