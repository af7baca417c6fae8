// Resumable uploads, as other resources refer to them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "server/store/uploads.h"

namespace lares::api {

// A form's part of this type holds a reference to a finished upload in the place of the bytes.
inline constexpr std::string_view kUploadReference = "application/vnd.lares.upload";

// What was referred to by the upload's id, path or address. Throws kInvalid (no such reference, not
// whole), kNotFound (the upload does not exist any more), "upload-locked".
std::unique_ptr<store::UploadClaim> ClaimUpload(store::Uploads& uploads,
                                                const std::string& reference);

// The file name that its metadata tell, made safe; "" when they tell none.
std::string UploadFileName(const store::UploadInfo& upload);

}  // namespace lares::api
