// The data that plsc wrote into this page.
export function readData() {
  return JSON.parse(document.getElementById("data").textContent);
}
