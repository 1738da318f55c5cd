console.log("talus");
