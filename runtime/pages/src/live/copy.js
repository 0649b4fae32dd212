// This page with another robot in it: the file that it came from, but for its
// data. To be made before anything else is put into the document.

export class PageCopy {
  constructor(data) {
    this.data = data;
    this.head = document.head.outerHTML;
    this.loader = document.getElementById("data").nextElementSibling.textContent;
  }

  // {robot, name, scenario}; what else the page knows stays.
  with(robot) {
    const json = JSON.stringify({ ...this.data, ...robot }).replaceAll("<", "\\u003c");
    return `<!DOCTYPE html>
<html lang="en">
${this.head}
<body>
<script type="application/json" id="data">${json}</script>
<script>
${this.loader}</script>
</body>
</html>
`;
  }
}
