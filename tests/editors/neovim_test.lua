-- Neovim as a client of `plsc lsp`: opens a broken file, waits for what is said
-- of it, applies a code action, hovers, renames, formats. Run as
--   PLSC=plsc PLSC_SOURCE=. nvim --headless --clean -u neovim_test.lua
-- with the settings that docs/editors/README.md tells people to use.
-- Ends with status 0, or 1 and the reason.

local file = vim.fn.tempname() .. ".pls"
local text = {
  "plsc 1",
  "alphabet plasticoding 1",
  "sense inclined: bool",
  "let half = 0.5",
  "# a gecko: 🦎",
  "rule C -> if inclind = True then { C add_front T(half) }",
  "environment flat { inclined = False }",
  "environment tilted { inclined = True }",
}
local limit = 10000 -- ms, for an answer; a slow machine under load needs 100

local function check(holds, what)
  if holds then return end
  io.stderr:write("neovim_test: expected " .. what .. "\n")
  vim.cmd("cquit! 1")
end

local function wait(what, holds)
  check(vim.wait(limit, function() return holds() and true or false end, 5), what)
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

local function contains(what)
  return table.concat(lines(), "\n"):find(what, 1, true) ~= nil
end

local function main()
  local readme = table.concat(vim.fn.readfile(vim.env.PLSC_SOURCE .. "/docs/editors/README.md"), "\n")
  local settings = readme:match("\n```lua\n(.-)\n```")
  check(settings, "settings in docs/editors/README.md")
  vim.env.PATH = vim.fn.fnamemodify(vim.env.PLSC, ":h") .. ":" .. vim.env.PATH
  loadstring(settings)()
  vim.fn.writefile(text, file)
  vim.cmd("edit " .. file)
  check(vim.bo.filetype == "pls", "the type of the file")
  local buffer = vim.api.nvim_get_current_buf()
  wait("the server to start", function() return next(vim.lsp.buf_get_clients(buffer)) end)
  local client = next(vim.lsp.buf_get_clients(buffer))
  local server = vim.lsp.get_client_by_id(client)
  local function ask(method, params)
    local answer = server.request_sync(method, params, limit, buffer)
    check(answer and not answer.err, "an answer to " .. method .. ", got " .. vim.inspect(answer))
    return answer.result
  end

  -- What is wrong with the file.
  wait("a diagnostic", function() return #vim.diagnostic.get(buffer) > 0 end)
  local wrong = vim.diagnostic.get(buffer)[1]
  check(wrong.code == "P2005" and wrong.lnum == 5 and wrong.col == 13,
    "the misspelt state at 6:14, got " .. vim.inspect(wrong))

  -- Its fix.
  vim.api.nvim_win_set_cursor(0, { 6, 14 })
  local line = { start = { line = 5, character = 14 }, ["end"] = { line = 5, character = 14 } }
  local fixed = false
  for _, action in ipairs(ask("textDocument/codeAction", {
    textDocument = vim.lsp.util.make_text_document_params(),
    range = line,
    context = { diagnostics = vim.lsp.diagnostic.get_line_diagnostics(buffer, 5) },
  })) do
    if action.title == "Replace 'inclind' by 'inclined'" then
      vim.lsp.util.apply_workspace_edit(action.edit, "utf-16")
      fixed = true
    end
  end
  check(fixed, "the fix among the code actions")
  wait("the fix in the text", function() return contains("if inclined = True") end)
  wait("no error any more", function()
    return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) == 0
  end)

  -- A hover: the truth table of the clause.
  local params = vim.lsp.util.make_position_params(0, "utf-16")
  local hover = ask("textDocument/hover", params)
  check(hover.contents.value:find("Active in 1 of 2 environments", 1, true),
    "a truth table, got " .. vim.inspect(hover))

  -- Where the state is declared.
  vim.lsp.buf.definition()
  wait("the cursor at the declaration", function()
    return vim.api.nvim_win_get_cursor(0)[1] == 3
  end)

  -- Another name for it, in a file that has an emoji before.
  vim.api.nvim_win_set_cursor(0, { 6, 14 })
  vim.lsp.buf.rename("steep")
  wait("the new name in the rule", function() return contains("if steep = True") end)
  check(contains("sense steep: bool") and contains("tilted { steep = True }"),
    "the new name everywhere, got\n" .. table.concat(lines(), "\n"))
  check(not contains("inclined"), "the old name nowhere")

  -- Which rules are active in an environment.
  ask("workspace/executeCommand", { command = "plsc.chooseEnvironment", arguments = { "tilted" } })
  local hints = ask("textDocument/inlayHint", {
    textDocument = vim.lsp.util.make_text_document_params(),
    range = { start = { line = 0, character = 0 }, ["end"] = { line = 99, character = 0 } },
  })
  check(#hints == 1 and hints[1].label == "active", "one active rule, got " .. vim.inspect(hints))

  -- Completion and the outline, by Neovim's own readers.
  vim.api.nvim_buf_set_lines(buffer, -1, -1, false, { "rule B -> { add_" })
  vim.api.nvim_win_set_cursor(0, { #lines(), 16 })
  local items = vim.lsp.util.text_document_completion_list_to_complete_items(
    ask("textDocument/completion", vim.lsp.util.make_position_params(0, "utf-16")), "add_")
  check(#items == 4, "four symbols that begin with add_, got " .. #items)
  wait("the broken rule to be told", function() return #vim.diagnostic.get(buffer) > 0 end)
  vim.api.nvim_buf_set_lines(buffer, -2, -1, false, {})
  local outline = vim.lsp.util.symbols_to_items(
    ask("textDocument/documentSymbol", { textDocument = vim.lsp.util.make_text_document_params() }), buffer)
  check(#outline == 6, "six symbols, got " .. #outline)

  -- The layout of plsc fmt.
  if vim.lsp.buf.format then
    vim.lsp.buf.format({ async = false, timeout_ms = limit })
  else -- Neovim 0.7
    vim.lsp.buf.formatting_sync({}, limit)
  end
  check(contains("rule C -> if steep = True then {\n  C\n"),
    "the formatted text, got\n" .. table.concat(lines(), "\n"))

  -- A goodbye.
  server.stop()
  wait("the server to end", function() return server.is_stopped() end)
  vim.cmd("set nomodified")
end

local fine, why = pcall(main)
vim.fn.delete(file)
check(fine, "no Lua error, got " .. tostring(why))
vim.cmd("quitall!")
