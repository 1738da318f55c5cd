console.log('talus');
