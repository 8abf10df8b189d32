-- Debugging with nvim-dap: call require("technol_dap") after nvim-dap is loaded.
local dap = require("dap")

dap.adapters.technol = { type = "executable", command = "technol", args = { "dap" } }

--- The project of the current file: the nearest folder with a manifest, or the file itself.
local function project()
  local file = vim.api.nvim_buf_get_name(0)
  local manifest = vim.fs.find("technol.toml", { upward = true, path = file })[1]
  return manifest and vim.fs.dirname(manifest) or file
end

dap.configurations.technol = {
  { type = "technol", request = "launch", name = "Run on the embedded target", program = project, target = "embedded" },
  {
    type = "technol",
    request = "launch",
    name = "Run on the embedded target, stopped at first",
    program = project,
    target = "embedded",
    stopOnEntry = true,
  },
  {
    type = "technol",
    request = "attach",
    name = "Attach to a target",
    program = project,
    target = function()
      return vim.fn.input("Target (tcp:HOST:PORT or serial:DEVICE@BAUD): ", "tcp:127.0.0.1:5700")
    end,
  },
}
