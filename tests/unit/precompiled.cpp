// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
// The one source of its library that uses the precompiled header: without any, CMake has no header
// for the tests to share.
