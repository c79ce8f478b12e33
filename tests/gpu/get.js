// SPDX-License-Identifier: MIT
//
// Gets a file from browser.py.
export async function get(name) {
    const response = await fetch(name);
    if (!response.ok) {
        throw new Error(`there is no ${name}`);
    }
    return response;
}
